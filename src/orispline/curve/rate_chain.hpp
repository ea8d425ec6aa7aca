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

namespace orispline { inline namespace ORISPLINE_ABI {

/// The accelerations of one piece of a curve at its two ends.
template <Number T>
struct EndAccelerations {
  Vector3<T> start, end;
};

/// The straight space of positions: cubic pieces. d is the displacement, h the duration [s].
class FlatPiece {
 public:
  FlatPiece(const Eigen::Vector3d& d, double h) : chord_(6.0 / (h * h) * d), frequency_(1.0 / h) {}

  template <Number T>
  [[nodiscard]] EndAccelerations<T> accelerations(const Vector3<T>& leaving, const Vector3<T>& arriving) const {
    const Vector3<T> chord = constant<T>(chord_);
    return {chord - (leaving * 4.0 + arriving * 2.0) * frequency_,
            (leaving * 2.0 + arriving * 4.0) * frequency_ - chord};
  }
  [[nodiscard]] bool plausible(const Eigen::Vector3d&) const noexcept { return true; }

 private:
  Eigen::Vector3d chord_;
  double frequency_;  ///< [1/s]
};

/// Cubics by de Casteljau's algorithm with slerps, handles of one third of the rate.
///
/// Source: Bogfjellmo, Modin & Verdier 2018, in closed form on the unit quaternions.
class SlerpBezierPiece {
 public:
  SlerpBezierPiece(const Eigen::Vector3d& d, double h) : turn_(exp<double>(d)), step_(h) {}

  template <Number T>
  [[nodiscard]] EndAccelerations<T> accelerations(const Vector3<T>& leaving, const Vector3<T>& arriving) const {
    const Vector3<T> first = leaving * (step_ / 3.0), last = arriving * (step_ / 3.0);
    const Vector3<T> middle = log<T>(exp<T>(-first) * constant<T>(turn_) * exp<T>(-last));
    const double scale = 6.0 / (step_ * step_);
    return {(right_jacobian_inverse<T>(first) * middle - first) * scale,
            (last - right_jacobian_inverse<T>(-last) * middle) * scale};
  }
  /// Beyond a full turn the handle of a key would alias: such a solution has jumps.
  [[nodiscard]] bool plausible(const Eigen::Vector3d& rate) const noexcept {
    return rate.norm() * step_ / 3.0 < 2.0 * std::numbers::pi;
  }

 private:
  Eigen::Quaterniond turn_;
  double step_;
};

/// Cubic rotation vectors in the chart at the left key. Source: McEnnan 2003.
class LeftChartPiece {
 public:
  LeftChartPiece(const Eigen::Vector3d& d, double h)
      : flat_(d, h), slope_(right_jacobian_inverse<double>(d)), end_(d) {}

  template <Number T>
  [[nodiscard]] EndAccelerations<T> accelerations(const Vector3<T>& leaving, const Vector3<T>& arriving) const {
    const Vector3<T> slope = slope_ * arriving;
    const EndAccelerations<T> flat = flat_.accelerations<T>(leaving, slope);
    return {flat.start, end_(slope, flat.end)};
  }
  [[nodiscard]] bool plausible(const Eigen::Vector3d&) const noexcept { return true; }

 private:
  FlatPiece flat_;
  Eigen::Matrix3d slope_;  ///< the derivative in the chart of a body rate at the end
  ChartAcceleration end_;
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
    pieces_.reserve(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      increments_.push_back(share * increments[i]);
      pieces_.emplace_back(increments_[i], steps_[i]);
    }
    for (auto* given : {&conditions_.start, &conditions_.end})
      if (*given) **given *= share;
    for (std::size_t i = 0; i < size(); ++i) equations_.push_back(equation(i));
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
    std::vector<Vector3<T>> residual;
    residual.reserve(size());
    for (std::size_t i = 0; i < size(); ++i)
      residual.push_back(rate(i) * equations_[i].rate - constant<T>(equations_[i].wanted));
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const std::size_t next = after(i);
      const EndAccelerations<T> piece = pieces_[i].template accelerations<T>(rate(i), rate(next));
      residual[i] += piece.start * equations_[i].leaving;
      residual[next] += piece.end * equations_[next].arriving;
    }
    return residual;
  }

  void jacobian(const chain::TakeBlock& take) const {
    for (std::size_t i = 0; i < size(); ++i) take(i, i, equations_[i].rate * Eigen::Matrix3d::Identity());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const std::size_t next = after(i);
      const auto piece = pieces_[i].template accelerations<Dual<6>>(chain::variables<6>(rates_[i], 0),
                                                                    chain::variables<6>(rates_[next], 3));
      take(i, i, equations_[i].leaving * chain::derivatives(piece.start, 0));
      take(i, next, equations_[i].leaving * chain::derivatives(piece.start, 3));
      take(next, i, equations_[next].arriving * chain::derivatives(piece.end, 0));
      take(next, next, equations_[next].arriving * chain::derivatives(piece.end, 3));
    }
  }

  /// How equation i changes per unit of the ν of its key, at rates that solve it.
  [[nodiscard]] Eigen::Vector3d residual_per_nu(std::size_t i) const { return equations_[i].arriving * rates_[i]; }

  void move(std::span<const Eigen::Vector3d> by) {
    for (std::size_t i = 0; i < by.size(); ++i) rates_[i] += by[i];
  }

  [[nodiscard]] bool plausible() const {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (!pieces_[i].plausible(rates_[i]) || !pieces_[i].plausible(rates_[after(i)])) return false;
    return true;
  }

 private:
  [[nodiscard]] bool has_before(std::size_t i) const { return i > 0 || closed(); }
  [[nodiscard]] bool has_after(std::size_t i) const { return i < steps_.size(); }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : steps_.size() - 1; }
  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }

  /// That of the parabola through a key and its neighbours; at an end the given one or the secant.
  [[nodiscard]] Eigen::Vector3d guess(std::size_t i) const {
    if (!has_before(i)) return conditions_.start.value_or(increments_[i] / steps_[i]);
    if (!has_after(i)) return conditions_.end.value_or(increments_[i - 1] / steps_[i - 1]);
    const double h0 = steps_[before(i)], h1 = steps_[i];
    return (h1 / h0 * increments_[before(i)] + h0 / h1 * increments_[i]) / (h0 + h1);
  }

  /// What the accelerations on arriving at a key and on leaving it, and its rate, must sum to with these weights.
  struct Equation {
    double arriving = 0.0, leaving = 0.0, rate = 0.0;
    Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
  };

  /// Scaled to an angle by the steps beside the key.
  [[nodiscard]] Equation equation(std::size_t i) const {
    if (!has_before(i) || !has_after(i)) {
      const double h = steps_[has_after(i) ? i : i - 1];
      if (const auto& given = has_after(i) ? conditions_.start : conditions_.end)
        return {.rate = h, .wanted = h * *given};
      return has_after(i) ? Equation{.leaving = -h * h / 4.0} : Equation{.arriving = h * h / 4.0};
    }
    const double nu = conditions_.nu[i], stiffness = 1.0 / steps_[before(i)] + 1.0 / steps_[i];
    const double scale = 1.0 / (stiffness * (4.0 * stiffness + std::abs(nu)));
    return {.arriving = scale, .leaving = -scale, .rate = nu * scale};
  }

  std::vector<double> steps_;
  std::vector<Eigen::Vector3d> increments_;
  std::vector<Piece> pieces_;
  std::vector<Equation> equations_;
  RateConditions conditions_;
  double share_;
  std::vector<Eigen::Vector3d> rates_;
};

/// The chain with rates that solve it. Errors: not_converged.
template <class Piece>
[[nodiscard]] Expected<RateChain<Piece>> solved_rate_chain(std::string_view method,
                                                           std::span<const Eigen::Vector3d> increments,
                                                           const Knots& knots, const RateConditions& conditions) {
  std::vector<double> steps;
  for (std::size_t i = 0; i < knots.segments(); ++i) steps.push_back(knots.span(i).step());
  using Chain = RateChain<Piece>;
  return solve_chain(
      method, [&](double share, const Chain* before) { return Chain(increments, steps, conditions, share, before); });
}

/// The rates at the keys, at a loop's return too. Errors: not_converged.
template <class Piece>
[[nodiscard]] Expected<std::vector<Eigen::Vector3d>> solve_rates(std::string_view method,
                                                                 std::span<const Eigen::Vector3d> increments,
                                                                 const Knots& knots, const RateConditions& conditions) {
  return solved_rate_chain<Piece>(method, increments, knots, conditions).map([](const RateChain<Piece>& chain) {
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

}}  // namespace orispline
