// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/window.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The polynomial through all keys of a window (2 to 7), in Newton's form. Refers to the window.
class WindowPolynomial {
 public:
  explicit WindowPolynomial(const Window& window) noexcept;

  /// Derivatives of orders 1…3 at the window's centre.
  [[nodiscard]] std::array<Eigen::Vector3d, 3> derivatives() const noexcept;
  /// The first two of these.
  [[nodiscard]] WindowRates rates() const noexcept;

  /// How far the keys from number `first` to before `past` lie from the polynomials through all others: the sum of
  /// squares.
  [[nodiscard]] double left_out_error(std::size_t first, std::size_t past) const noexcept;

 private:
  const Window& window_;
  std::array<Eigen::Vector3d, Window::capacity> difference_;  ///< the one of order i is that of the first i + 1 keys
};

}}  // namespace orispline
