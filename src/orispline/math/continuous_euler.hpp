// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/euler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The angle of the same direction that is nearest to another [rad].
[[nodiscard]] inline double nearest_angle(double angle, double to) noexcept {
  return to + std::remainder(angle - to, 2.0 * std::numbers::pi);
}

/// Euler angles that follow one another without jumps: full turns are counted, and at the pole nothing flips.
class ContinuousEuler {
 public:
  explicit ContinuousEuler(const EulerOrder& order) noexcept : order_(order) {}

  /// The angles [rad] of an orientation that are nearest to those before it: of the two triples that make it, with any
  /// full turns.
  [[nodiscard]] Eigen::Vector3d after(const Eigen::Vector3d& before, const Eigen::Quaterniond& q) const noexcept {
    constexpr double pi = std::numbers::pi;
    const Eigen::Vector3d angles = euler_angles(order_, q);
    if (lock_distance(angles) <= at_lock) return at_the_lock(before, angles);
    const double mirrored = order_.is_proper() ? -angles[1] : pi - angles[1];
    const Eigen::Vector3d one = nearest(angles, before);
    const Eigen::Vector3d other = nearest({angles[0] + pi, mirrored, angles[2] + pi}, before);
    return (one - before).squaredNorm() <= (other - before).squaredNorm() ? one : other;
  }

  /// How far the second turn is from where the first and the third have one axis [rad].
  [[nodiscard]] double lock_distance(const Eigen::Vector3d& angles) const noexcept {
    constexpr double pi = std::numbers::pi;
    return order_.is_proper() ? std::abs(std::remainder(angles[1], pi))
                              : std::abs(std::remainder(angles[1] - pi / 2, pi));
  }

 private:
  static constexpr double at_lock = 1e-12;  // [rad], where euler_angles() gives an outer angle as 0

  [[nodiscard]] static Eigen::Vector3d nearest(Eigen::Vector3d angles, const Eigen::Vector3d& to) noexcept {
    for (Eigen::Index i = 0; i < 3; ++i) angles[i] = nearest_angle(angles[i], to[i]);
    return angles;
  }

  /// Only a sum or a difference of the outer angles means anything: both take half of its step.
  [[nodiscard]] Eigen::Vector3d at_the_lock(const Eigen::Vector3d& before,
                                            const Eigen::Vector3d& angles) const noexcept {
    constexpr double pi = std::numbers::pi;
    // Turns about the axes of the world are those about the axes of the body in reverse order.
    const int first = order_.turns[order_.axes == EulerOrder::Axes::of_world ? 2 : 0];
    const bool is_right_handed = (order_.turns[1] - first + 3) % 3 == 1;
    const bool is_sum = order_.is_proper() ? angles[1] < pi / 2 : (angles[1] > 0.0) == is_right_handed;
    const double sign = is_sum ? 1.0 : -1.0;
    const double step = std::remainder(angles[0] + sign * angles[2] - before[0] - sign * before[2], 2.0 * pi);
    return {before[0] + step / 2, nearest_angle(angles[1], before[1]), before[2] + sign * step / 2};
  }

  EulerOrder order_;
};

}}  // namespace orispline
