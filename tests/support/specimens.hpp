// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/math/so3.hpp>

namespace orispline::testing_support {

using std::numbers::pi;

/// Rotation angles [rad] at which formulas break: near 0, near π, beyond π, near 2π, and ordinary ones between.
inline constexpr std::array specimen_angles{
    0.0,       1e-300,    1e-160, 1e-20, 1e-12, 1e-8,  1e-4,          1e-2,          0.5,
    1.0,       1.44,      1.45,   1.999, 2.0,   2.001, 3.0,           pi - 1e-3,     pi,
    pi - 1e-9, pi + 1e-9, 3.2,    3.999, 4.001, 5.0,   2 * pi - 1e-2, 2 * pi - 1e-6, 2 * pi - 1e-12};

[[nodiscard]] inline Eigen::Quaterniond about_x(double angle) { return exp<double>({angle, 0.0, 0.0}); }
[[nodiscard]] inline Eigen::Quaterniond about_z(double angle) { return exp<double>({0.0, 0.0, angle}); }

/// A time of these years since 1970 [s]; a double there is exact to 1.2e-7 s.
inline constexpr double today = 1.7e9;

/// Unit axes: along the frame, against it, oblique.
[[nodiscard]] inline std::vector<Eigen::Vector3d> specimen_axes() {
  return {{1, 0, 0}, {0, 0, -1}, {2.0 / 3, -2.0 / 3, 1.0 / 3}, {-0.36, 0.48, 0.8}};
}

[[nodiscard]] inline std::vector<Eigen::Vector3d> specimen_rotation_vectors() {
  std::vector<Eigen::Vector3d> all;
  for (const double angle : specimen_angles)
    for (const Eigen::Vector3d& axis : specimen_axes()) all.push_back(angle * axis);
  return all;
}

/// Numbers in [0, 1) from a literal seed (splitmix64): the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * (*this)(); }
  Eigen::Vector3d vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

 private:
  std::uint64_t state_;
};

enum class Spacing { even, uneven };

/// Keys of a random walk: steps up to `largest_step` [rad] about ever new axes; uneven times have spacing ratios of 10.
[[nodiscard]] inline KeyframeData random_walk(std::uint64_t seed, std::size_t count, Spacing spacing,
                                              double largest_step = 1.5) {
  Dice dice(seed);
  KeyframeData data;
  double t = dice.between(-1.0, 1.0);
  Eigen::Quaterniond q = exp<double>(2.0 * dice.vector());
  for (std::size_t i = 0; i < count; ++i) {
    data.times.push_back(t);
    data.orientations.push_back(q);
    t += spacing == Spacing::even ? 0.5 : i % 3 == 0 ? 1.0 : i % 3 == 1 ? 0.1 : dice.between(0.1, 1.0);
    const Eigen::Vector3d axis = dice.vector().normalized();  // first, whatever order a compiler takes operands in
    q = q * exp<double>(largest_step * dice.between(0.3, 1.0) * axis);
  }
  return data;
}

/// Keys on one great arc: q(t) = exp(t ω) at the times given.
[[nodiscard]] inline KeyframeData steady_rotation(const std::vector<double>& times, const Eigen::Vector3d& rate) {
  KeyframeData data{.times = times};
  const Eigen::Quaterniond start = exp<double>(Eigen::Vector3d(0.3, -0.2, 0.5));
  for (const double t : times) data.orientations.push_back(start * exp<double>(rate * (t - times.front())));
  return data;
}

/// Valid data becomes keyframes; anything else is a mistake of the test.
[[nodiscard]] inline Keyframes keyframes(KeyframeData data, Signs signs = Signs::as_given) {
  return Keyframes::make(std::move(data), signs).value();
}

/// `count` times per segment, the knots and the inside, first and last included.
[[nodiscard]] inline std::vector<double> sample_times(std::span<const double> knots, std::size_t count = 5) {
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (std::size_t k = 0; k < count; ++k)
      times.push_back(knots[i] + (knots[i + 1] - knots[i]) * static_cast<double>(k) / static_cast<double>(count));
  times.push_back(knots.back());
  return times;
}

}  // namespace orispline::testing_support
