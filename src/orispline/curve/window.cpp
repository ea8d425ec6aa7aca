// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/window.hpp>

#include <orispline/base/expect.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

std::array<Eigen::Vector3d, Window::capacity> divided_differences(const Window& window) noexcept {
  std::array<Eigen::Vector3d, Window::capacity> difference = window.displacements;
  const auto& t = window.times;
  for (std::size_t order = 1; order < window.size; ++order)
    for (std::size_t i = window.size - 1; i >= order; --i)
      difference[i] = (difference[i] - difference[i - 1]) / (t[i] - t[i - order]);
  return difference;
}

std::array<Eigen::Vector3d, 3> polynomial_derivatives(const Window& window) noexcept {
  ORISPLINE_EXPECT(window.size >= 2 && window.size <= Window::capacity);
  // Newton form by divided differences, then value and three derivatives at time 0 by Horner's rule.
  const std::array<Eigen::Vector3d, Window::capacity> difference = divided_differences(window);
  const auto& t = window.times;
  Eigen::Vector3d value = difference[window.size - 1];
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = first, third = first;
  for (std::size_t i = window.size - 1; i-- > 0;) {
    third = 3.0 * second - t[i] * third;
    second = 2.0 * first - t[i] * second;
    first = value - t[i] * first;
    value = difference[i] - t[i] * value;
  }
  return {first, second, third};
}

WindowRates polynomial_rates(const Window& window) noexcept {
  const auto derivatives = polynomial_derivatives(window);
  return {derivatives[0], derivatives[1]};
}

WindowRates natural_spline_rates(const Window& window) noexcept {
  ORISPLINE_EXPECT(window.size >= 2 && window.size <= Window::capacity);
  // Second derivatives M: h₋M₋ + 2(h₋ + h₊)M + h₊M₊ = 6 (secant₊ - secant₋), zero at both ends; Thomas' algorithm.
  const std::size_t last = window.size - 1, c = window.centre;
  std::array<double, Window::capacity> upper;
  std::array<Eigen::Vector3d, Window::capacity> second;
  upper[0] = 0.0;
  second[0].setZero();
  second[last].setZero();
  Eigen::Vector3d secant = window.secant(0);
  for (std::size_t i = 1; i < last; ++i) {
    const double before = window.step(i - 1), after = window.step(i);
    const double pivot = 2.0 * (before + after) - before * upper[i - 1];
    const Eigen::Vector3d next = window.secant(i);
    upper[i] = after / pivot;
    second[i] = (6.0 * (next - secant) - before * second[i - 1]) / pivot;
    secant = next;
  }
  for (std::size_t i = last; i-- > std::max<std::size_t>(c, 1);) second[i] -= upper[i] * second[i + 1];
  const Eigen::Vector3d slope =
      c < last ? Eigen::Vector3d(window.secant(c) - window.step(c) / 6.0 * (2.0 * second[c] + second[c + 1]))
               : Eigen::Vector3d(window.secant(c - 1) + window.step(c - 1) / 6.0 * (2.0 * second[c] + second[c - 1]));
  return {slope, second[c]};
}

}}  // namespace orispline
