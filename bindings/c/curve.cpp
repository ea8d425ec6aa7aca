// SPDX-License-Identifier: Apache-2.0
#include "curve.hpp"

#include <algorithm>
#include <optional>

#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

#include "errors.hpp"
#include "keys.hpp"

namespace orispline::c { namespace {

/// The one that the text names, else the one that the keys are for, else the usual one.
Expected<Method> method_stated(const char* text, const Track& track) {
  if (text) return method_from_text(text);
  return jobs::chosen_method(std::nullopt, track, jobs::UsualMethod{}).map([](jobs::ChosenMethod chosen) {
    return std::move(chosen.method);
  });
}

Expected<HeldCurve> curve_through(std::shared_ptr<const Track> track, const Method& stated) {
  return jobs::shaped_curve(stated, *track).map([&](PoseCurve pose) {
    return HeldCurve{track, completed(stated, jobs::family_of(stated), *track), PoseSampler(std::move(pose))};
  });
}

Expected<void> check_side(orispline_side side) {
  if (side == ORISPLINE_RIGHT || side == ORISPLINE_LEFT) return {};
  return bad_option("side", formatted("found {}, wanted ORISPLINE_RIGHT or ORISPLINE_LEFT", side));
}

void put(double* to, const Eigen::Vector3d& v) noexcept { std::ranges::copy(v, to); }

void put(orispline_motion& to, const Motion& motion, orispline_order order) noexcept {
  put_quaternion(to.orientation, motion.orientation, order);
  put(to.angular_velocity, motion.angular_velocity);
  put(to.angular_acceleration, motion.angular_acceleration);
  put(to.angular_jerk, motion.angular_jerk);
}

void put(orispline_motion& to, const LinearMotion& motion) noexcept {
  put(to.position, motion.position);
  put(to.velocity, motion.velocity);
  put(to.acceleration, motion.acceleration);
  put(to.jerk, motion.jerk);
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_curve_make(const orispline_keys* keys, const char* method, orispline_curve** curve,
                                    orispline_error** error) {
  return guarded(error, [&] {
    return cleared(curve, "curve")
        .and_then([&] { return checked(keys); })
        .and_then([&](const Keys* body) {
          return method_stated(method, *body->track).and_then([&](const Method& stated) {
            return curve_through(body->track, stated);
          });
        })
        .map([&](HeldCurve made) { *curve = handle_of<orispline_curve>(std::move(made)); });
  });
}

orispline_code orispline_curve_domain(const orispline_curve* curve, double* start, double* end,
                                      orispline_error** error) {
  return guarded(error, [&] {
    return check_pointer(start, "start")
        .and_then([&] { return check_pointer(end, "end"); })
        .and_then([&] { return checked(curve); })
        .map([&](const HeldCurve* body) {
          *start = body->pose().orientation.domain().start;
          *end = body->pose().orientation.domain().end;
        });
  });
}

orispline_code orispline_curve_method(const orispline_curve* curve, char** text, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(text, "text").and_then([&] { return checked(curve); }).map([&](const HeldCurve* body) {
      *text = text_of_c(text_of(body->method));
    });
  });
}

int32_t orispline_curve_has_positions(const orispline_curve* curve) {
  const HeldCurve* const body = body_of(curve);
  return body && body->pose().position ? 1 : 0;
}

orispline_code orispline_curve_orientation(const orispline_curve* curve, double time, orispline_order order,
                                           double* orientation, orispline_error** error) {
  const HeldCurve* const body = body_of(curve);
  if (body && orientation && (order == ORISPLINE_WXYZ || order == ORISPLINE_XYZW)) {  // nothing else, frame by frame
    put_quaternion(orientation, body->pose().orientation(time), order);
    return ORISPLINE_OK;
  }
  return guarded(error, [&] {
    return checked(curve)
        .and_then([&](const HeldCurve*) { return check_pointer(orientation, "orientation"); })
        .and_then([&] { return check_order(order); });
  });
}

orispline_code orispline_curve_motion(const orispline_curve* curve, double time, orispline_side side,
                                      orispline_order order, orispline_motion* motion, orispline_error** error) {
  return guarded(error, [&]() -> Expected<void> {
    const auto body = checked(curve);
    if (!body) return tl::unexpected(body.error());
    return check_pointer(motion, "motion")
        .and_then([&] { return check_side(side); })
        .and_then([&] { return check_order(order); })
        .map([&] {
          const PoseCurve& pose = (*body)->pose();
          const Side beside = side == ORISPLINE_LEFT ? Side::left : Side::right;
          put(*motion, pose.orientation.motion(time, beside), order);
          put(*motion, pose.position ? pose.position->linear_motion(time, beside) : no_motion<Eigen::Vector3d>());
        });
  });
}

void orispline_curve_free(orispline_curve* curve) { free_handle(curve); }

orispline_code orispline_method_text(const char* method, char** text, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(text, "text")
        .and_then([&] { return check_pointer(method, "method"); })
        .and_then([&] { return method_from_text(method); })
        .map([&](const Method& read) { *text = text_of_c(text_of(read)); });
  });
}
