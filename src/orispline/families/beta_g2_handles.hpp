// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <numbers>
#include <span>
#include <vector>

#include <orispline/curve/beta_polygon.hpp>
#include <orispline/curve/chain.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// One of each per key.
template <Number T>
struct BetasOver {
  std::vector<T> beta1, beta2;
};

[[nodiscard]] inline BetasOver<double> betas_of(const FamilySettings& settings, std::size_t keys) {
  return {settings.per_key("beta1").all(keys), settings.per_key("beta2").all(keys)};
}

/// The increment in another frame: that behind a turn by `turn`. In space there is nothing to turn.
template <CurvePoint P, Number T>
[[nodiscard]] Vector3<T> seen_behind(const Vector3<T>& turn, const Vector3<T>& increment) {
  if constexpr (std::same_as<P, Eigen::Quaterniond>) return to_body<T>(exp<T>(turn), increment);
  else return increment;
}

/// What the acceleration of a cubic lacks at its left joint: β₁² α + β₂ ω of the cubic before less its own α, rates in
/// the local parameter. At its ends a cubic has ω = 3 φ₁ and 3 φ₃, α = 6 (φ₂ - φ₁) and 6 (φ₃ - φ₂), this φ₂ seen behind
/// φ₃.
template <Number T>
[[nodiscard]] Vector3<T> lacking_acceleration(const std::array<Vector3<T>, 3>& before,
                                              const std::array<Vector3<T>, 3>& after, const T& beta1, const T& beta2) {
  const Vector3<T> arriving = (before[2] - seen_behind<Eigen::Quaterniond, T>(before[2], before[1])) * T(6.0);
  return arriving * T(beta1 * beta1) + before[2] * T(beta2 * T(3.0)) - (after[1] - after[0]) * T(6.0);
}

/// Handles v_i of beta-g2 in the form `global`, the last increments of the cubic segments before the keys; behind a key
/// it is β₁ v. A ChainProblem.
///
/// With x the middle increments the Beta constraint is x_i = (β₁ + β₁² + β₂/2) v_i - β₁² x_{i-1} seen behind v_i. The
/// rates of the end increments are given.
template <CurvePoint P>
class HandleChain {
 public:
  HandleChain(std::vector<P> keys, BetasOver<double> betas, const HandleChain* before)
      : keys_(std::move(keys)), betas_(std::move(betas)) {
    for (std::size_t i = 0; i < size(); ++i) handles_.push_back(before ? before->handles_[i] : starting_handle(i));
  }

  [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }
  [[nodiscard]] bool closed() const noexcept { return false; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& handles() const noexcept { return handles_; }

  /// The increments of segment i with these handles.
  template <Number T>
  [[nodiscard]] std::array<Vector3<T>, 3> increments(std::size_t i, std::span<const Vector3<T>> v,
                                                     const BetasOver<T>& betas) const {
    const Vector3<T> leaving = v[i] * betas.beta1[i];
    return {leaving,
            displacement(displaced(constant<T>(keys_[i]), leaving),
                         displaced(constant<T>(keys_[i + 1]), Vector3<T>(-v[i + 1]))),
            v[i + 1]};
  }
  [[nodiscard]] std::array<Eigen::Vector3d, 3> increments(std::size_t i) const {
    return increments<double>(i, handles_, betas_);
  }

  /// What the equations miss with these handles and betas.
  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> missing(std::span<const Vector3<T>> v, const BetasOver<T>& betas) const {
    std::vector<Vector3<T>> missing;
    for (std::size_t i = 0; i < size(); ++i) {
      if (i == 0 || i + 1 == size()) {
        missing.push_back(v[i] - constant<T>(starting_handle(i)));
        continue;
      }
      const T &b1 = betas.beta1[i], &b2 = betas.beta2[i], square = b1 * b1, weight = b1 + square + b2 * T(0.5);
      const Vector3<T> x = increments<T>(i, v, betas)[1];
      const Vector3<T> arriving = seen_behind<P, T>(v[i], increments<T>(i - 1, v, betas)[1]);
      missing.push_back((x - v[i] * weight + arriving * square) * T(T(1.0) / (T(1.0) + weight + square)));
    }
    return missing;
  }

  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> steps) const {
    std::vector<Vector3<T>> v;
    for (std::size_t i = 0; i < size(); ++i) v.push_back(constant<T>(handles_[i]) + steps[i]);
    return missing<T>(v, {{betas_.beta1.begin(), betas_.beta1.end()}, {betas_.beta2.begin(), betas_.beta2.end()}});
  }

  void move(std::span<const Vector3<double>> steps) {
    for (std::size_t i = 0; i < size(); ++i) handles_[i] += steps[i];
  }

  /// No handle is longer than half a turn.
  [[nodiscard]] bool plausible() const {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      for (std::size_t i = 0; i < size(); ++i)
        if (!(std::max(1.0, betas_.beta1[i]) * handles_[i].norm() < std::numbers::pi)) return false;
    return true;
  }

 private:
  /// A third of the increment at an end, the mean of both at an inner key.
  [[nodiscard]] Eigen::Vector3d starting_handle(std::size_t i) const {
    const std::size_t last = size() - 1;
    const Eigen::Vector3d before = i > 0 ? displacement(keys_[i - 1], keys_[i]) : displacement(keys_[0], keys_[1]);
    const Eigen::Vector3d after = i < last ? displacement(keys_[i], keys_[i + 1]) : before;
    return (before + after) / 6.0;
  }

  std::vector<P> keys_;
  BetasOver<double> betas_;
  std::vector<Eigen::Vector3d> handles_;
};

}}}  // namespace orispline::families
