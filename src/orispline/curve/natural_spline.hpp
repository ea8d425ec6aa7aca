// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/window.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The natural cubic spline through all keys of a window (2 to 7); beyond its ends it is a line. Refers to the window.
class NaturalSpline {
 public:
  explicit NaturalSpline(const Window& window) noexcept;

  /// At the window's centre.
  [[nodiscard]] WindowRates rates() const noexcept;

  /// How far the keys from number `first` to before `past` lie from the splines through all others: the sum of squares.
  /// Of 3 keys and more.
  [[nodiscard]] double left_out_error(std::size_t first, std::size_t past) const noexcept;

 private:
  const Window& window_;
  std::size_t last_;                                               ///< key
  std::array<double, Window::capacity> per_step_;                  ///< one over each step [1/s]
  std::array<double, Window::capacity> inverse_pivot_, upper_;     ///< of the elimination, at the inner keys
  std::array<Eigen::Vector3d, Window::capacity> secant_, second_;  ///< after each key, and the derivative there
};

}}  // namespace orispline
