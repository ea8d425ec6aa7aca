// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/left_out.hpp>

#include <algorithm>

#include <orispline/base/expect.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t key_count = Window::capacity, last_key = key_count - 1;

/// The error at key j is the divided difference of all keys times the product of the distances to the others.
double polynomial_error(const Window& window, std::size_t first, std::size_t past) {
  const auto& t = window.times;
  double sum = 0.0;
  for (std::size_t j = first; j < past; ++j) {
    double product = 1.0;
    for (std::size_t k = 0; k < key_count; ++k)
      if (k != j) product *= t[j] - t[k];
    sum += product * product;
  }
  return sum * divided_differences(window)[last_key].squaredNorm();
}

/// The error at key j is J_j/B_jj: with Qᵀ the differences of neighbouring secants and T the matrix of the spline's
/// second derivatives M at the inner keys, T M = QᵀL, the jumps of the third derivative are J = Q M, and B = Q T⁻¹ Qᵀ
/// is how they answer to a key that moves (Green & Silverman 1994, section 2.3). Of T⁻¹ only five diagonals are needed.
double natural_spline_error(const Window& window, std::size_t first, std::size_t past) {
  std::array<double, last_key> step, per_step;
  for (std::size_t i = 0; i < last_key; ++i) {
    step[i] = window.step(i);
    per_step[i] = 1.0 / step[i];
  }
  // T = L D Lᵀ, and M; keys 0 and `last_key` have no second derivative, which the rows of zeros state.
  std::array<double, key_count> pivot{}, factor{};
  std::array<Eigen::Vector3d, key_count> second;
  second[0].setZero();
  second[last_key].setZero();
  for (std::size_t i = 1; i < last_key; ++i) {
    const double beside = i > 1 ? step[i - 1] / 6.0 : 0.0;
    factor[i - 1] = i > 1 ? beside / pivot[i - 1] : 0.0;
    pivot[i] = (step[i - 1] + step[i]) / 3.0 - factor[i - 1] * beside;
    second[i] = window.secant(i) - window.secant(i - 1) - factor[i - 1] * second[i - 1];
  }
  std::array<double, key_count> own{}, next{}, after{};  // T⁻¹ at (i, i), (i, i + 1) and (i, i + 2)
  for (std::size_t i = last_key; i-- > 1;) {
    second[i] = second[i] / pivot[i] - factor[i] * second[i + 1];
    after[i] = -factor[i] * next[i + 1];
    next[i] = -factor[i] * own[i + 1];
    own[i] = 1.0 / pivot[i] - factor[i] * next[i];
  }
  double sum = 0.0;
  for (std::size_t j = first; j < past; ++j) {
    const std::size_t left = j > 0 ? j - 1 : 0, right = std::min(j + 1, last_key);
    const double a = j > 0 ? per_step[left] : 0.0, c = j < last_key ? per_step[j] : 0.0, b = -(a + c);
    const Eigen::Vector3d jump = a * second[left] + b * second[j] + c * second[right];
    const double answer = a * a * own[left] + b * b * own[j] + c * c * own[right] +
                          2.0 * (a * b * next[left] + b * c * next[j] + a * c * after[left]);
    sum += jump.squaredNorm() / (answer * answer);
  }
  return sum;
}

}  // namespace

LeftOutErrors left_out_errors(const Window& window, std::size_t first, std::size_t past) noexcept {
  ORISPLINE_EXPECT(window.size == key_count && past <= key_count);
  return {polynomial_error(window, first, past), natural_spline_error(window, first, past)};
}

}}  // namespace orispline
