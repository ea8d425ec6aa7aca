// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <orispline/curve/curve.hpp>
#include <orispline/math/geodesic.hpp>
#include <support/specimens.hpp>

namespace orispline::testing_support {

/// A random walk with random positions along it [m].
[[nodiscard]] inline KeyframeData posed_walk(std::uint64_t seed, std::size_t count, Spacing spacing,
                                             double largest_step = 0.8) {
  KeyframeData data = random_walk(seed, count, spacing, largest_step);
  Dice dice(seed + 1);
  for (std::size_t i = 0; i < count; ++i) data.positions.push_back(3.0 * dice.vector());
  return data;
}

/// The same keys in the other order, at the times -t.
[[nodiscard]] inline KeyframeData reversed(const KeyframeData& data) {
  KeyframeData backwards = data;
  for (double& t : backwards.times) t = -t;
  std::ranges::reverse(backwards.times);
  std::ranges::reverse(backwards.orientations);
  std::ranges::reverse(backwards.positions);
  return backwards;
}

/// Largest angle between a(t) and b(t) [rad], at seven times per segment of a.
[[nodiscard]] inline double largest_distance(const AnyCurve& a, const AnyCurve& b) {
  double largest = 0.0;
  for (const double t : sample_times(a.knots().times(), 7)) largest = std::max(largest, angular_distance(a(t), b(t)));
  return largest;
}

/// Largest angle between a(t) and b(-t) [rad].
[[nodiscard]] inline double largest_distance_from_backwards(const AnyCurve& a, const AnyCurve& b) {
  double largest = 0.0;
  for (const double t : sample_times(a.knots().times(), 7)) largest = std::max(largest, angular_distance(a(t), b(-t)));
  return largest;
}

/// Largest angle between the curve and the slerps between its keys [rad], these run through with rest at every key: at
/// u² (3 - 2u).
[[nodiscard]] inline double largest_distance_from_stopping_slerps(const AnyCurve& curve, const KeyframeData& keys) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < keys.times.size(); ++i)
    for (const double u : {0.1, 0.25, 0.4, 0.5, 0.7, 0.85, 1.0}) {
      const Eigen::Quaterniond on_arc =
          slerp<double>(keys.orientations[i], keys.orientations[i + 1], u * u * (3.0 - 2.0 * u));
      largest = std::max(largest, angular_distance(curve((1.0 - u) * keys.times[i] + u * keys.times[i + 1]), on_arc));
    }
  return largest;
}

/// ∫|α|² dt [rad²/s³]: Gauss and Legendre's five points on every quarter of a segment.
[[nodiscard]] inline double energy(const AnyCurve& curve) {
  constexpr std::array<std::pair<double, double>, 5> rule{{{0.0, 0.5688888888888889},
                                                           {-0.5384693101056831, 0.4786286704993665},
                                                           {0.5384693101056831, 0.4786286704993665},
                                                           {-0.9061798459386640, 0.2369268850561891},
                                                           {0.9061798459386640, 0.2369268850561891}}};
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.knots().segments(); ++i) {
    const KnotSpan span = curve.knots().span(i);
    const double half = span.step() / 8.0;
    for (const double middle : {1.0, 3.0, 5.0, 7.0})
      for (const auto& [x, weight] : rule)
        sum += half * weight * curve.motion(span.start() + half * (middle + x)).angular_acceleration.squaredNorm();
  }
  return sum;
}

}  // namespace orispline::testing_support
