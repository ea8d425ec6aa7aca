// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>

#include <orispline/analysis.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/fields/warning_json.hpp>

#include "curve.hpp"
#include "errors.hpp"
#include "json_text.hpp"

namespace orispline::c { namespace {

orispline_jump jump_of(const RateJump& jump) {
  return {jump.largest, jump.relative, static_cast<std::int64_t>(jump.key)};
}

orispline_peak peak_of(const Peak& peak) { return {peak.value, peak.time}; }

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

Expected<Eigen::Matrix3d> inertia_in(const double* inertia) {
  if (!inertia) return Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  return checked_inertia(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(inertia));
}

Seam seam_of(const HeldCurve& curve) { return curve.method.options.loop ? Seam::closed : Seam::open; }

/// Of the keys at knots; at others, such as control points, no segments meet. A loop may have a knot more, its first
/// key.
void put_orders(std::int32_t* to, const HeldCurve& curve) {
  const AnyCurve& orientation = curve.pose().orientation;
  const auto keys = curve.track->keys.times(), knots = orientation.knots().times();
  const std::vector<int> orders = orders_at_keys(orientation, seam_of(curve));
  for (std::size_t key = 0, knot = 0; key < keys.size(); ++key)
    to[key] = knot < knots.size() && knots[knot] == keys[key] ? orders[knot++] : 3;
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_curve_continuity(const orispline_curve* curve, orispline_continuity* found,
                                          orispline_error** error) {
  return guarded(error, [&] {
    return check_pointer(found, "found").and_then([&] { return checked(curve); }).map([&](const HeldCurve* body) {
      const Continuity continuity = continuity_at_keys(body->pose().orientation, seam_of(*body));
      *found = {.order = continuity.order(),
                .angular_velocity = jump_of(continuity.angular_velocity),
                .angular_acceleration = jump_of(continuity.angular_acceleration),
                .angular_jerk = jump_of(continuity.angular_jerk),
                .orientation_jump = continuity.orientation.angle,
                .orientation_jump_time = continuity.orientation.time};
    });
  });
}

orispline_code orispline_curve_orders(const orispline_curve* curve, int32_t* orders, size_t count,
                                      orispline_error** error) {
  return guarded(error, [&] {
    return check_pointer(orders, "orders")
        .and_then([&] { return checked(curve); })
        .and_then([&](const HeldCurve* body) {
          const std::size_t keys = body->track->keys.size();
          if (count != keys)
            return Expected<void>(bad_option("count", formatted("found {}, wanted {}, as many as keys", count, keys)));
          put_orders(orders, *body);
          return Expected<void>();
        });
  });
}

orispline_code orispline_curve_peaks(const orispline_curve* curve, const double* inertia, orispline_peaks* found,
                                     orispline_error** error) {
  std::array<double, 3> bounds;
  return orispline_curve_bounded_peaks(curve, inertia, found, bounds.data(), error);
}

orispline_code orispline_curve_bounded_peaks(const orispline_curve* curve, const double* inertia,
                                             orispline_peaks* found, double* bounds, orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    const auto body = checked(curve);
    if (!body) return tl::unexpected(body.error());
    return check_pointer(found, "found")
        .and_then([&] { return check_pointer(bounds, "bounds"); })
        .and_then([&] { return inertia_in(inertia); })
        .map([&](const Eigen::Matrix3d& matrix) {
          Peaks largest = peaks((*body)->pose().orientation, matrix);
          if (!inertia) largest.torque = {absent, absent};
          *found = {.angular_velocity = peak_of(largest.angular_velocity),
                    .angular_acceleration = peak_of(largest.angular_acceleration),
                    .torque = peak_of(largest.torque)};
          bounds[0] = largest.angular_velocity.bound.value_or(absent);
          bounds[1] = largest.angular_acceleration.bound.value_or(absent);
          bounds[2] = largest.torque.bound.value_or(absent);
        });
  });
}

orispline_code orispline_curve_warnings(const orispline_curve* curve, char** json, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(json, "json").and_then([&] { return checked(curve); }).map([&](const HeldCurve* body) {
      *json = text_of_c(json_text(warnings_json(warnings_of(body->method, *body->track))));
    });
  });
}
