// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A few neighbouring keys seen from one of them: times and increments from it, at most seven.
struct Window {
  static constexpr std::size_t capacity = 7;
  std::size_t size = 0;
  std::size_t centre = 0;                                 ///< the key that the others are seen from
  std::array<double, capacity> times{};                   ///< since the centre [s], increasing
  std::array<Eigen::Vector3d, capacity> displacements{};  ///< increment from the centre to each key

  [[nodiscard]] double step(std::size_t i) const noexcept { return times[i + 1] - times[i]; }
  [[nodiscard]] Eigen::Vector3d secant(std::size_t i) const noexcept {
    return (1.0 / step(i)) * (displacements[i + 1] - displacements[i]);
  }
};

/// Keys first … first + count - 1 seen from key `centre`; `displacement(i, j)` is the increment from key i to key j.
template <class Displacement>
[[nodiscard]] Window window_of(std::span<const double> times, std::size_t centre, std::size_t first, std::size_t count,
                               const Displacement& displacement) {
  Window window{.size = count, .centre = centre - first};
  for (std::size_t k = 0; k < count; ++k) {
    window.times[k] = times[first + k] - times[centre];
    window.displacements[k] = displacement(centre, first + k);
  }
  return window;
}

/// The window of `reach` keys on either side of key `centre`, shifted inwards at the ends; all keys if there are fewer.
template <class Displacement>
[[nodiscard]] Window shifted_window(std::span<const double> times, std::size_t centre, std::size_t reach,
                                    const Displacement& displacement) {
  const std::size_t count = std::min(2 * reach + 1, times.size());
  const std::size_t first = std::min(centre - std::min(centre, reach), times.size() - count);
  return window_of(times, centre, first, count, displacement);
}

/// First and second derivative of a fit at the window's centre.
struct WindowRates {
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = Eigen::Vector3d::Zero();
};

[[nodiscard]] inline WindowRates blended(const WindowRates& a, const WindowRates& b, double share_of_b) noexcept {
  return {a.first + share_of_b * (b.first - a.first), a.second + share_of_b * (b.second - a.second)};
}

}}  // namespace orispline
