// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <orispline/math/eigen.hpp>

namespace orispline {

/// A few neighbouring keys seen from one of them: times and increments from it, at most seven.
struct Window {
  static constexpr std::size_t capacity = 7;
  std::size_t size = 0;
  std::size_t centre = 0;                                 ///< the key that the others are seen from
  std::array<double, capacity> times{};                   ///< since the centre [s], increasing
  std::array<Eigen::Vector3d, capacity> displacements{};  ///< increment from the centre to each key

  [[nodiscard]] double step(std::size_t i) const noexcept { return times[i + 1] - times[i]; }
  [[nodiscard]] Eigen::Vector3d secant(std::size_t i) const noexcept {
    return (displacements[i + 1] - displacements[i]) / step(i);
  }
};

/// First and second derivative of a fit at the window's centre.
struct WindowRates {
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = Eigen::Vector3d::Zero();
};

[[nodiscard]] inline WindowRates blended(const WindowRates& a, const WindowRates& b, double share_of_b) noexcept {
  return {a.first + share_of_b * (b.first - a.first), a.second + share_of_b * (b.second - a.second)};
}

/// Of the polynomial through all keys of the window (2 to 7).
[[nodiscard]] WindowRates polynomial_rates(const Window& window) noexcept;

/// Of the natural cubic spline through the keys of the window (2 to 7).
[[nodiscard]] WindowRates natural_spline_rates(const Window& window) noexcept;

}  // namespace orispline
