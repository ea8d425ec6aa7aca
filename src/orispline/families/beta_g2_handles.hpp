// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include <orispline/curve/chain.hpp>
#include <orispline/families/betas.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

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
/// rates of the end increments are given; around a loop all keys are inner ones.
template <CurvePoint P>
class HandleChain {
 public:
  HandleChain(std::vector<P> keys, Betas betas, std::optional<Closure> closure, const HandleChain* before)
      : keys_(std::move(keys)), betas_(std::move(betas)), closure_(closure) {
    for (std::size_t i = 0; i < size(); ++i) handles_.push_back(before ? before->handles_[i] : starting_handle(i));
  }

  [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }
  [[nodiscard]] bool closed() const noexcept { return closure_.has_value(); }
  [[nodiscard]] std::size_t segments() const noexcept { return closed() ? size() : size() - 1; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& handles() const noexcept { return handles_; }

  /// The increments of segment i with these handles.
  template <Number T>
  [[nodiscard]] std::array<Vector3<T>, 3> increments(std::size_t i, std::span<const Vector3<T>> v,
                                                     const BetasOver<T>& betas) const {
    const Vector3<T> leaving = v[i] * betas.beta1[i];
    return {leaving,
            displacement(displaced(constant<T>(keys_[i]), leaving),
                         displaced(constant<T>(key_behind(i)), Vector3<T>(-v[behind(i)]))),
            v[behind(i)]};
  }
  [[nodiscard]] std::array<Eigen::Vector3d, 3> increments(std::size_t i) const {
    return increments<double>(i, handles_, betas_);
  }

  /// What the equations miss with these handles and betas.
  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> missing(std::span<const Vector3<T>> v, const BetasOver<T>& betas) const {
    std::vector<Vector3<T>> missing;
    for (std::size_t i = 0; i < size(); ++i) {
      if (!closed() && (i == 0 || i + 1 == size())) {
        missing.push_back(v[i] - constant<T>(starting_handle(i)));
        continue;
      }
      const T &b1 = betas.beta1[i], &b2 = betas.beta2[i], square = b1 * b1, weight = b1 + square + b2 * T(0.5);
      const Vector3<T> x = increments<T>(i, v, betas)[1];
      const Vector3<T> arriving = seen_behind<P, T>(v[i], increments<T>(before(i), v, betas)[1]);
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
  [[nodiscard]] std::size_t before(std::size_t i) const noexcept { return (i + size() - 1) % size(); }
  [[nodiscard]] std::size_t behind(std::size_t i) const noexcept { return (i + 1) % size(); }
  [[nodiscard]] P key_behind(std::size_t i) const {
    return i + 1 < size() ? keys_[i + 1] : come_round(keys_[0], *closure_);
  }
  [[nodiscard]] Eigen::Vector3d step(std::size_t i) const { return displacement(keys_[i], key_behind(i)); }

  /// A third of the increment at an end, the mean of both at an inner key.
  [[nodiscard]] Eigen::Vector3d starting_handle(std::size_t i) const {
    const bool at_start = !closed() && i == 0, at_end = !closed() && i + 1 == size();
    const Eigen::Vector3d arriving = step(at_start ? 0 : before(i));
    return (arriving + (at_end ? arriving : step(i))) / 6.0;
  }

  std::vector<P> keys_;
  Betas betas_;
  std::optional<Closure> closure_;
  std::vector<Eigen::Vector3d> handles_;
};

}}}  // namespace orispline::families
