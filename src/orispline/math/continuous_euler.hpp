// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <orispline/math/euler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The angle of the same direction that is nearest to another [rad].
[[nodiscard]] inline double nearest_angle(double angle, double to) noexcept {
  return to + std::remainder(angle - to, 2.0 * std::numbers::pi);
}

/// Euler angles that follow one another without jumps: full turns are counted, and at the pole nothing flips.
///
/// Steps are as short as they can be over a whole track, not only one by one: taking the other triple at both ends of a
/// step changes nothing in its length, so what is chosen for one step costs no other. With the turn ρ between two
/// orientations, their distances δ and δ' from the lock, Δ = δ + δ' and m = (Δ - ρ)/2, the norm of a step is at most
/// ρ / (√2 sin(m/2)) where m > 0, and nowhere above √((π² + (ρ + Δ)²)/2 + Δ²).
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

  /// The track of angles [rad] of a whole track of orientations; the first ones are the nearest to `start`. At the lock
  /// what the orientations leave open goes evenly from the frame before to the frame behind.
  [[nodiscard]] std::vector<Eigen::Vector3d> over(std::span<const Eigen::Quaterniond> track,
                                                  const Eigen::Vector3d& start) const {
    std::vector<Eigen::Vector3d> found;
    found.reserve(track.size());
    std::size_t locked = 0;  // frames at the lock before the next one
    for (const Eigen::Quaterniond& q : track) {
      found.push_back(after(found.empty() ? start : found.back(), q));
      const std::size_t k = found.size() - 1;
      if (lock_distance(found[k]) <= at_lock) {
        if (locked > 0 && direction_at_lock(found[k - 1]) != direction_at_lock(found[k])) locked = 0;
        ++locked;
        continue;
      }
      if (locked > 0) spread(found, k, std::exchange(locked, 0));
    }
    return found;
  }

  /// How far the second turn is from where the first and the third have one axis [rad].
  [[nodiscard]] double lock_distance(const Eigen::Vector3d& angles) const noexcept {
    constexpr double pi = std::numbers::pi;
    return order_.is_proper() ? std::abs(std::remainder(angles[1], pi))
                              : std::abs(std::remainder(angles[1] - pi / 2, pi));
  }

 private:
  static constexpr double at_lock = 1e-13;  // [rad], where euler_angles() gives an outer angle as 0, or rounding

  [[nodiscard]] static Eigen::Vector3d nearest(Eigen::Vector3d angles, const Eigen::Vector3d& to) noexcept {
    for (Eigen::Index i = 0; i < 3; ++i) angles[i] = nearest_angle(angles[i], to[i]);
    return angles;
  }

  /// At the lock the first turn and so many times the third have one effect: 1, or -1.
  [[nodiscard]] double direction_at_lock(const Eigen::Vector3d& angles) const noexcept {
    // Turns about the axes of the world are those about the axes of the body in reverse order.
    const int first = order_.turns[order_.axes == EulerOrder::Axes::of_world ? 2 : 0];
    const bool is_right_handed = (order_.turns[1] - first + 3) % 3 == 1;
    const double second = std::remainder(angles[1], 2.0 * std::numbers::pi);
    const bool is_sum =
        order_.is_proper() ? std::abs(second) < std::numbers::pi / 2 : (second > 0.0) == is_right_handed;
    return is_sum ? 1.0 : -1.0;
  }

  /// Only a sum or a difference of the outer angles means anything: both take half of its step.
  [[nodiscard]] Eigen::Vector3d at_the_lock(const Eigen::Vector3d& before,
                                            const Eigen::Vector3d& angles) const noexcept {
    const double sign = direction_at_lock(angles);
    const double step =
        std::remainder(angles[0] + sign * angles[2] - before[0] - sign * before[2], 2.0 * std::numbers::pi);
    return {before[0] + step / 2, nearest_angle(angles[1], before[1]), before[2] + sign * step / 2};
  }

  /// The frames before `end`, at the lock, take their parts of what the step to `end` has beside its effect; all of it
  /// where the track begins with them.
  void spread(std::vector<Eigen::Vector3d>& angles, std::size_t end, std::size_t count) const noexcept {
    const double sign = direction_at_lock(angles[end - 1]);
    const Eigen::Vector3d step = angles[end] - angles[end - 1];
    const Eigen::Vector3d without_effect = (step[0] - sign * step[2]) / 2 * Eigen::Vector3d(1.0, 0.0, -sign);
    const bool begins = count == end;
    for (std::size_t i = 1; i <= count; ++i)
      angles[end - 1 - count + i] +=
          begins ? without_effect
                 : Eigen::Vector3d(static_cast<double>(i) / static_cast<double>(count + 1) * without_effect);
  }

  EulerOrder order_;
};

}}  // namespace orispline
