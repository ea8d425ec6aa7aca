// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/window_polynomial.hpp>

#include <orispline/base/expect.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

WindowPolynomial::WindowPolynomial(const Window& window) noexcept : window_(window), difference_(window.displacements) {
  ORISPLINE_EXPECT(window.size >= 2 && window.size <= Window::capacity);
  const auto& t = window.times;
  for (std::size_t order = 1; order < window.size; ++order)
    for (std::size_t i = window.size - 1; i >= order; --i)
      difference_[i] = (1.0 / (t[i] - t[i - order])) * (difference_[i] - difference_[i - 1]);
}

std::array<Eigen::Vector3d, 3> WindowPolynomial::derivatives() const noexcept {
  // Value and three derivatives at time 0 by Horner's rule.
  const auto& t = window_.times;
  Eigen::Vector3d value = difference_[window_.size - 1];
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = first, third = first;
  for (std::size_t i = window_.size - 1; i-- > 0;) {
    third = 3.0 * second - t[i] * third;
    second = 2.0 * first - t[i] * second;
    first = value - t[i] * first;
    value = difference_[i] - t[i] * value;
  }
  return {first, second, third};
}

WindowRates WindowPolynomial::rates() const noexcept {
  const auto all = derivatives();
  return {all[0], all[1]};
}

double WindowPolynomial::left_out_error(std::size_t first, std::size_t past) const noexcept {
  // The error at key j is the divided difference of all keys times the product of the distances to the others.
  const auto& t = window_.times;
  double sum = 0.0;
  for (std::size_t j = first; j < past; ++j) {
    double product = 1.0;
    for (std::size_t k = 0; k < window_.size; ++k)
      if (k != j) product *= t[j] - t[k];
    sum += product * product;
  }
  return sum * difference_[window_.size - 1].squaredNorm();
}

}}  // namespace orispline
