// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/curve.hpp>

// Curves made of curves, in the order of their quaternions. The rates are exact, by the rules of products (our
// derivation): with R the rotation of b, ω = Rᵀ ω_a + ω_b, all in body frames.

namespace orispline { inline namespace ORISPLINE_ABI {

/// The motion of q⁻¹: its rates are minus those of q in the world frame.
[[nodiscard]] inline Motion inverse(const Motion& m) noexcept {
  return {.orientation = m.orientation.conjugate(),
          .angular_velocity = -angular_velocity_world(m),
          .angular_acceleration = -angular_acceleration_world(m),
          .angular_jerk = -angular_jerk_world(m)};
}

/// The motion of the product of two orientations that move.
[[nodiscard]] inline Motion product(const Motion& a, const Motion& b) noexcept {
  const Eigen::Quaterniond into = b.orientation.conjugate();
  // What a adds, as b's body sees it, with the derivatives of that.
  const Eigen::Vector3d turned = to_world<double>(into, a.angular_acceleration);
  const Eigen::Vector3d rate = to_world<double>(into, a.angular_velocity);
  const Eigen::Vector3d acceleration = turned - b.angular_velocity.cross(rate);
  const Eigen::Vector3d jerk = to_world<double>(into, a.angular_jerk) - b.angular_velocity.cross(turned) -
                               b.angular_acceleration.cross(rate) - b.angular_velocity.cross(acceleration);
  return {.orientation = a.orientation * b.orientation,
          .angular_velocity = rate + b.angular_velocity,
          .angular_acceleration = acceleration + b.angular_acceleration,
          .angular_jerk = jerk + b.angular_jerk};
}

/// The curve q(t)⁻¹, as fast as q.
[[nodiscard]] ORISPLINE_EXPORT AnyCurve inverse_of(const AnyCurve& curve);

/// The times on the clocks of two curves at 0 of their product's [s].
struct ClockOffsets {
  double a = 0.0, b = 0.0;
};

/// The times of a curve at times of another clock. Rounding leads none of them over an end of a gap or over a jump.
class ORISPLINE_EXPORT ShiftedClock {
 public:
  /// `offset`: the time of the curve at 0 of the other clock [s].
  ShiftedClock(const AnyCurve& curve, double offset);

  [[nodiscard]] double operator()(double t) const noexcept;

 private:
  double offset_, rounding_;
  std::vector<double> breaks_{};
};

/// The curve a(t + offsets.a) b(t + offsets.b) where both are, with the knots of both.
///
/// Error (bad_argument): curves without a time in common.
[[nodiscard]] ORISPLINE_EXPORT Expected<AnyCurve> product_of(const AnyCurve& a, const AnyCurve& b,
                                                             ClockOffsets offsets = {});

}}  // namespace orispline
