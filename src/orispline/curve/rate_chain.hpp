// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>
#include <utility>

#include <orispline/curve/chain.hpp>
#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/hermite_path.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline {

/// The accelerations of one piece of a curve at its two ends.
template <Number T>
struct EndAccelerations {
  Vector3<T> start, end;
};

/// The straight space of positions: cubic pieces. d is the displacement, h the duration [s].
struct FlatPiece {
  template <Number T>
  [[nodiscard]] static EndAccelerations<T> accelerations(const Vector3<T>& leaving, const Eigen::Vector3d& d,
                                                         const Vector3<T>& arriving, double h) {
    const Vector3<T> chord = constant<T>(Eigen::Vector3d(6.0 / (h * h) * d));
    return {chord - (leaving * T(4.0) + arriving * T(2.0)) * T(1.0 / h),
            (leaving * T(2.0) + arriving * T(4.0)) * T(1.0 / h) - chord};
  }
  [[nodiscard]] static bool plausible(const Eigen::Vector3d&, double) noexcept { return true; }
};

/// Cubics by de Casteljau's algorithm with slerps, handles of one third of the rate.
///
/// Source: Bogfjellmo, Modin & Verdier 2018, in closed form on the unit quaternions.
struct SlerpBezierPiece {
  template <Number T>
  [[nodiscard]] static EndAccelerations<T> accelerations(const Vector3<T>& leaving, const Eigen::Vector3d& d,
                                                         const Vector3<T>& arriving, double h) {
    const Vector3<T> first = leaving * T(h / 3.0), last = arriving * T(h / 3.0);
    const Vector3<T> middle = log<T>(exp<T>(-first) * constant<T>(exp<double>(d)) * exp<T>(-last));
    const T scale(6.0 / (h * h));
    return {(right_jacobian_inverse<T>(first) * middle - first) * scale,
            (last - right_jacobian_inverse<T>(-last) * middle) * scale};
  }
  /// Beyond a full turn the handle of a key would alias: such a solution has jumps.
  [[nodiscard]] static bool plausible(const Eigen::Vector3d& rate, double h) noexcept {
    return rate.norm() * h / 3.0 < 2.0 * std::numbers::pi;
  }
};

/// Cubic rotation vectors in the chart at the left key. Source: McEnnan 2003.
struct LeftChartPiece {
  template <Number T>
  [[nodiscard]] static EndAccelerations<T> accelerations(const Vector3<T>& leaving, const Eigen::Vector3d& d,
                                                         const Vector3<T>& arriving, double h) {
    const Vector3<T> chord = constant<T>(d), slope = right_jacobian_inverse<T>(chord) * arriving;
    const EndAccelerations<T> flat = FlatPiece::accelerations<T>(leaving, d, slope, h);
    Vector3<Jet<T, 2>> path;
    for (Eigen::Index axis = 0; axis < 3; ++axis) path[axis].c = {chord[axis], slope[axis], flat.end[axis] * T(0.5)};
    const auto rate = chart_rate<T, 2>(path);
    return {flat.start, Vector3<T>(rate.x().c[1], rate.y().c[1], rate.z().c[1])};
  }
  [[nodiscard]] static bool plausible(const Eigen::Vector3d&, double) noexcept { return true; }
};

/// What a chain of rates asks for beside smoothness at the inner keys.
struct RateConditions {
  std::optional<Eigen::Vector3d> start{}, end{};  ///< given end rates [1/s]; absent: no acceleration there
  PerKey nu{std::vector{0.0}};                    ///< α⁺ - α⁻ = ν ω at the inner keys [1/s]
  bool closed = false;
};

/// The rates at the keys that join the pieces with equal accelerations, or with the jump that ν asks for.
///
/// n keys and the increments between them, n-1 of them or, closed, n. Depends on nothing else: the keys themselves only
/// place the curve.
template <class Piece>
class RateChain {
 public:
  RateChain(std::span<const Eigen::Vector3d> increments, std::span<const double> steps, RateConditions conditions,
            double share, const RateChain* before)
      : steps_(steps.begin(), steps.end()), conditions_(std::move(conditions)), share_(share) {
    for (const Eigen::Vector3d& d : increments) increments_.push_back(share * d);
    for (auto* given : {&conditions_.start, &conditions_.end})
      if (*given) **given *= share;
    if (before) {
      for (const Eigen::Vector3d& rate : before->rates_) rates_.push_back(share / before->share_ * rate);
    } else {
      for (std::size_t i = 0; i < size(); ++i) rates_.push_back(guess(i));
    }
  }

  [[nodiscard]] std::size_t size() const { return increments_.size() + (closed() ? 0 : 1); }
  [[nodiscard]] bool closed() const { return conditions_.closed; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& rates() const { return rates_; }

  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> moved_by) const {
    const auto rate = [&](std::size_t i) -> Vector3<T> { return constant<T>(rates_[i]) + moved_by[i]; };
    std::vector<EndAccelerations<T>> pieces;
    pieces.reserve(steps_.size());
    for (std::size_t i = 0; i < steps_.size(); ++i)
      pieces.push_back(Piece::template accelerations<T>(rate(i), increments_[i], rate((i + 1) % size()), steps_[i]));
    std::vector<Vector3<T>> residual;
    residual.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) residual.push_back(equation<T>(i, rate(i), pieces));
    return residual;
  }

  void move(std::span<const Eigen::Vector3d> by) {
    for (std::size_t i = 0; i < by.size(); ++i) rates_[i] += by[i];
  }

  [[nodiscard]] bool plausible() const {
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (!Piece::plausible(rates_[i], steps_[i]) || !Piece::plausible(rates_[(i + 1) % size()], steps_[i]))
        return false;
    return true;
  }

 private:
  [[nodiscard]] bool has_before(std::size_t i) const { return i > 0 || closed(); }
  [[nodiscard]] bool has_after(std::size_t i) const { return i < steps_.size(); }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : steps_.size() - 1; }

  /// That of the parabola through a key and its neighbours; at an end the given one or the secant.
  [[nodiscard]] Eigen::Vector3d guess(std::size_t i) const {
    if (!has_before(i)) return conditions_.start.value_or(increments_[i] / steps_[i]);
    if (!has_after(i)) return conditions_.end.value_or(increments_[i - 1] / steps_[i - 1]);
    const double h0 = steps_[before(i)], h1 = steps_[i];
    return (h1 / h0 * increments_[before(i)] + h0 / h1 * increments_[i]) / (h0 + h1);
  }

  /// Scaled to an angle by the steps beside the key.
  template <Number T>
  [[nodiscard]] Vector3<T> equation(std::size_t i, const Vector3<T>& rate,
                                    const std::vector<EndAccelerations<T>>& pieces) const {
    if (!has_before(i)) {
      const double h = steps_[i];
      return conditions_.start ? Vector3<T>((rate - constant<T>(*conditions_.start)) * T(h))
                               : Vector3<T>(pieces[i].start * T(-h * h / 4.0));
    }
    if (!has_after(i)) {
      const double h = steps_[i - 1];
      return conditions_.end ? Vector3<T>((rate - constant<T>(*conditions_.end)) * T(h))
                             : Vector3<T>(pieces[i - 1].end * T(h * h / 4.0));
    }
    const double nu = conditions_.nu[i], stiffness = 1.0 / steps_[before(i)] + 1.0 / steps_[i];
    const double scale = 1.0 / (stiffness * (4.0 * stiffness + std::abs(nu)));
    return (pieces[before(i)].end - pieces[i].start + rate * T(nu)) * T(scale);
  }

  std::vector<double> steps_;
  std::vector<Eigen::Vector3d> increments_;
  RateConditions conditions_;
  double share_;
  std::vector<Eigen::Vector3d> rates_;
};

/// The rates at the keys, at a loop's return too. Errors: not_converged.
template <class Piece>
[[nodiscard]] Expected<std::vector<Eigen::Vector3d>> solve_rates(std::string_view method,
                                                                 std::span<const Eigen::Vector3d> increments,
                                                                 const Knots& knots, const RateConditions& conditions) {
  std::vector<double> steps;
  for (std::size_t i = 0; i < knots.segments(); ++i) steps.push_back(knots.span(i).step());
  using Chain = RateChain<Piece>;
  return solve_chain(method, [&](double share,
                                 const Chain* before) { return Chain(increments, steps, conditions, share, before); })
      .map([](const Chain& chain) {
        std::vector<Eigen::Vector3d> rates = chain.rates();
        if (chain.closed()) rates.push_back(rates.front());
        return rates;
      });
}

/// The conditions that the settings ask for; a secant end has the rate of its increment.
[[nodiscard]] RateConditions rate_conditions(const FamilySettings& settings,
                                             std::span<const Eigen::Vector3d> increments, const Knots& knots);

/// The C2 cubic through the positions, or with ν the cubic ν-spline: the Euclidean analogue of the solved curves.
///
/// Clamped ends, whose given rate is angular, are natural; the ends at rest are at rest. Source: Nielson 1974.
[[nodiscard]] Expected<HermitePath<3>> cubic_spline_path(std::string_view method, const Keyframes& keys,
                                                         const FamilySettings& settings);

}  // namespace orispline
