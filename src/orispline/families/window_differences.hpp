// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include <orispline/families/motion_models.hpp>

// All models are solved side by side, as lanes of the same arithmetic. The unknowns are not the eleven of the usual
// system, which has a line beside the keys, but the seven divided second differences, which feel no line: symmetric,
// positive definite, and a band of five where the velocity has no memory.

namespace orispline { inline namespace ORISPLINE_ABI { namespace families::models {

/// Intervals of a window, and its keys between others.
inline constexpr std::size_t window_intervals = window_keys - 1, inner_window_keys = window_keys - 2;

template <int N>
using Lanes = Eigen::Array<double, N, 1>;

/// The covariances of the second differences, L D Lᵀ. Row i has `Band` entries before its diagonal.
template <int N, std::size_t Band>
struct Covariances {
  std::array<std::array<Lanes<N>, inner_window_keys>, inner_window_keys> m;  // the lower triangle

  /// `scale`: what the diagonal is a difference of. Where keys are at nearly the same time it is only rounding.
  void factorise(const std::array<Lanes<N>, inner_window_keys>& scale) {
    constexpr double least_pivot = 1e-15;
    for (std::size_t k = 0; k < inner_window_keys; ++k) {
      m[k][k] = 1.0 / m[k][k].max(least_pivot * scale[k]);
      for (std::size_t i = std::min(k + Band, inner_window_keys - 1); i > k; --i) {
        const Lanes<N> factor = m[i][k] * m[k][k];
        for (std::size_t j = k + 1; j <= i; ++j) m[i][j] -= factor * m[j][k];
        m[i][k] = factor;
      }
    }
  }

  [[nodiscard]] std::array<Lanes<N>, inner_window_keys> solve(std::array<Lanes<N>, inner_window_keys> b) const {
    for (std::size_t i = 1; i < inner_window_keys; ++i)
      for (std::size_t k = i - std::min(i, Band); k < i; ++k) b[i] -= m[i][k] * b[k];
    for (std::size_t i = inner_window_keys; i-- > 0;) {
      b[i] *= m[i][i];
      for (std::size_t k = i + 1; k <= std::min(i + Band, inner_window_keys - 1); ++k) b[i] -= m[k][i] * b[k];
    }
    return b;
  }
};

/// The divided second differences of a window.
class Differences {
 public:
  explicit Differences(const WindowTimes& window) : centre_(window.centre) {
    for (std::size_t n = 0; n < window_intervals; ++n) step_[n] = window.x[n + 1] - window.x[n];
    for (std::size_t m = 0; m < inner_window_keys; ++m) {
      const double before = 1.0 / step_[m], after = 1.0 / step_[m + 1];
      z_[m] = {before, -(before + after), after};
    }
  }

  [[nodiscard]] double step(std::size_t n) const { return step_[n]; }
  [[nodiscard]] std::size_t centre() const { return centre_; }
  [[nodiscard]] std::size_t interval() const { return std::min(centre_, window_intervals - 1); }
  /// Of values at the keys.
  template <class Value>
  [[nodiscard]] std::array<Value, inner_window_keys> of(const std::array<Value, window_keys>& values) const {
    std::array<Value, inner_window_keys> found;
    for (std::size_t m = 0; m < inner_window_keys; ++m)
      found[m] = values[m] * z_[m][0] + values[m + 1] * z_[m][1] + values[m + 2] * z_[m][2];
    return found;
  }
  [[nodiscard]] std::array<double, inner_window_keys> of_key(std::size_t key) const {
    std::array<double, window_keys> unit{};
    unit[key] = 1.0;
    return of(unit);
  }
  /// The coefficient of a key in a sum of differences.
  template <int N>
  [[nodiscard]] Lanes<N> at_key(std::size_t key, const std::array<Lanes<N>, inner_window_keys>& of_differences) const {
    Lanes<N> sum = Lanes<N>::Zero();
    for (std::size_t part = 0; part < 3; ++part)
      if (key >= part && key - part < inner_window_keys) sum += z_[key - part][part] * of_differences[key - part];
    return sum;
  }
  /// Sum of products of two differences over the keys that they share.
  [[nodiscard]] double overlap(std::size_t m, std::size_t later) const {
    double sum = 0.0;
    for (std::size_t part = later - m; part < 3; ++part) sum += z_[m][part] * z_[later][part - (later - m)];
    return sum;
  }

 private:
  std::array<double, window_intervals> step_;
  std::array<std::array<double, 3>, inner_window_keys> z_;
  std::size_t centre_;
};

template <int N>
std::array<Lanes<N>, inner_window_keys> in_lanes(const std::array<double, inner_window_keys>& values) {
  std::array<Lanes<N>, inner_window_keys> lanes;
  for (std::size_t m = 0; m < inner_window_keys; ++m) lanes[m] = Lanes<N>::Constant(values[m]);
  return lanes;
}

template <int N>
Lanes<N> product(const std::array<double, inner_window_keys>& a, const std::array<Lanes<N>, inner_window_keys>& b) {
  Lanes<N> sum = Lanes<N>::Zero();
  for (std::size_t m = 0; m < inner_window_keys; ++m) sum += a[m] * b[m];
  return sum;
}

/// Fills the maps of N models from number `At` on. Beside the differences the first derivative has the secant.
template <int At, int N, std::size_t Band>
void put_maps(ModelMaps& maps, const Differences& d, const Covariances<N, Band>& covariances,
              const std::array<Lanes<N>, inner_window_keys>& first,
              const std::array<Lanes<N>, inner_window_keys>& second) {
  const auto of_centre = d.of_key(d.centre());
  const auto miss_of = covariances.solve(in_lanes<N>(of_centre));
  const auto first_of = covariances.solve(first), second_of = covariances.solve(second);
  const Lanes<N> precision = product(of_centre, miss_of);
  maps.precision.segment<N>(At) = precision;
  for (std::size_t j = 0; j < window_keys; ++j) {
    const double secant = (j == d.interval() + 1 ? 1.0 : j == d.interval() ? -1.0 : 0.0) / d.step(d.interval());
    maps.miss[j].segment<N>(At) = d.at_key(j, miss_of) / precision;
    maps.first[j].segment<N>(At) = d.at_key(j, first_of) + secant;
    maps.second[j].segment<N>(At) = d.at_key(j, second_of);
  }
}

/// Fills the maps of the models of velocity.
void put_velocity_maps(ModelMaps& maps, const Differences& d);

}}}  // namespace orispline::families::models
