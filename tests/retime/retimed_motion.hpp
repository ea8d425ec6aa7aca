// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/retime/rate_bounds.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline {

inline const std::optional<Eigen::Matrix3d> inertia = Eigen::Matrix3d(Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal());

inline bool is_warned_of(const Retiming& retiming, std::string_view code) {
  return std::ranges::find(retiming.warnings, code, &Warning::code) != retiming.warnings.end();
}

/// One value of each.
struct MotionSizes {
  double rate, acceleration, torque, jerk;  ///< [rad/s], [rad/s²], [N m], [rad/s³]
};

struct TurningPeaks {
  CertifiedPeak rate, acceleration, torque, jerk;
};

/// The lengths of these four.
inline std::vector<LimitedQuantity> lengths() {
  return quantities_of({.rate = 1.0, .acceleration = 1.0, .jerk = 1.0, .torque = 1.0});
}

inline std::optional<std::vector<TurningPeaks>> certified(const AnyCurve& curve,
                                                          const std::optional<Eigen::Matrix3d>& tensor,
                                                          const MotionSizes& floors) {
  const auto all = lengths();
  const auto peaks =
      certified_peaks({curve}, {all, tensor}, {floors.rate, floors.acceleration, floors.jerk, floors.torque});
  if (!peaks) return std::nullopt;
  std::vector<TurningPeaks> named;
  for (const SegmentPeaks& p : *peaks) named.push_back({p[0], p[1], p[3], p[2]});
  return named;
}

inline Keyframes at_times(const Keyframes& keys, std::vector<double> times) {
  return Keyframes::make(
             {.times = std::move(times), .orientations = {keys.orientations().begin(), keys.orientations().end()}},
             Signs::as_given)
      .value();
}

inline AnyCurve curve_of(std::string_view method, const Retiming& retiming) {
  return make_curve(method, retiming.track.keys).value();
}

inline Retiming retimed(std::string_view method, const Keyframes& keys, const MotionLimits& limits,
                        Slowing slowing = Slowing::uniform) {
  auto retiming = retime(keys, method, {.limits = limits, .slowing = slowing});
  EXPECT_TRUE(retiming) << describe(retiming.error());
  return retiming.value_or(Retiming{});
}

/// The largest of the whole curve at 2000 places of every segment.
inline MotionSizes sampled(const AnyCurve& curve) {
  MotionSizes largest{};
  for (std::size_t s = 0; s < curve.knots().segments(); ++s)
    for (int i = 0; i <= 2000; ++i) {
      const KnotSpan span = curve.knots().span(s);
      const Motion m = curve.motion_on(s, span.start() + 5e-4 * i * span.step());
      largest = {std::max(largest.rate, m.angular_velocity.norm()),
                 std::max(largest.acceleration, m.angular_acceleration.norm()),
                 std::max(largest.torque, torque(m, *inertia).norm()), std::max(largest.jerk, m.angular_jerk.norm())};
    }
  return largest;
}

/// Turns about one axis by angles at even times up to 1 s.
template <class Angle>
[[nodiscard]] Keyframes turning(Angle angle, std::size_t segments) {
  KeyframeData data;
  for (std::size_t i = 0; i <= segments; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(segments);
    data.times.push_back(u);
    data.orientations.push_back(exp<double>(angle(u) * Eigen::Vector3d(0.6, 0.0, 0.8)));
  }
  return Keyframes::make(std::move(data)).value();
}

[[nodiscard]] inline std::string error(std::string_view method, const Keyframes& keys, const MotionLimits& limits) {
  const auto retiming = retime(keys, method, {.limits = limits});
  return retiming ? std::string("none") : describe(retiming.error());
}

}  // namespace orispline
