// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/natural_spline.hpp>

#include <orispline/base/expect.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

NaturalSpline::NaturalSpline(const Window& window) noexcept : window_(window), last_(window.size - 1) {
  ORISPLINE_EXPECT(window.size >= 2 && window.size <= Window::capacity);
  // Second derivatives M: h₋M₋ + 2(h₋ + h₊)M + h₊M₊ = 6 (secant₊ - secant₋), zero at both ends; Thomas' algorithm.
  for (std::size_t i = 0; i < last_; ++i) {
    per_step_[i] = 1.0 / window.step(i);
    secant_[i] = per_step_[i] * (window.displacements[i + 1] - window.displacements[i]);
  }
  second_[0].setZero();
  second_[last_].setZero();
  double upper = 0.0;
  for (std::size_t i = 1; i < last_; ++i) {
    const double before = window.step(i - 1), after = window.step(i);
    inverse_pivot_[i] = 1.0 / (2.0 * (before + after) - before * upper);
    upper_[i] = upper = after * inverse_pivot_[i];
    second_[i] = inverse_pivot_[i] * (6.0 * (secant_[i] - secant_[i - 1]) - before * second_[i - 1]);
  }
  for (std::size_t i = last_; i-- > 1;) second_[i] -= upper_[i] * second_[i + 1];
}

WindowRates NaturalSpline::rates() const noexcept {
  const std::size_t c = window_.centre, beside = c < last_ ? c : c - 1, other = c < last_ ? c + 1 : c - 1;
  const double sixth = (c < last_ ? -1.0 : 1.0) / 6.0 * window_.step(beside);
  return {secant_[beside] + sixth * (2.0 * second_[c] + second_[other]), second_[c]};
}

/// The error at key j is J_j/B_jj: with Qᵀ the differences of neighbouring secants and T the matrix of the second
/// derivatives M, T M = QᵀL, the jumps of the third derivative are J = Q M, and B = Q T⁻¹ Qᵀ is how they answer to a
/// key that moves (Green & Silverman 1994, section 2.3). The equations above are those with 6 T, of whose inverse only
/// five diagonals are needed.
double NaturalSpline::left_out_error(std::size_t first, std::size_t past) const noexcept {
  ORISPLINE_EXPECT(last_ >= 2 && past <= window_.size);
  std::array<double, Window::capacity> own{}, next{}, after{};  // of the inverse, at (i, i), (i, i + 1) and (i, i + 2)
  for (std::size_t i = last_; i-- > 1;) {
    after[i] = -upper_[i] * next[i + 1];
    next[i] = -upper_[i] * own[i + 1];
    own[i] = inverse_pivot_[i] - upper_[i] * next[i];
  }
  double sum = 0.0;
  for (std::size_t j = first; j < past; ++j) {
    const std::size_t left = j > 0 ? j - 1 : 0, right = std::min(j + 1, last_);
    const double a = j > 0 ? per_step_[left] : 0.0, c = j < last_ ? per_step_[j] : 0.0, b = -(a + c);
    const Eigen::Vector3d jump = a * second_[left] + b * second_[j] + c * second_[right];
    const double answer = a * a * own[left] + b * b * own[j] + c * c * own[right] +
                          2.0 * (a * b * next[left] + b * c * next[j] + a * c * after[left]);
    sum += jump.squaredNorm() / (36.0 * answer * answer);
  }
  return sum;
}

}}  // namespace orispline
