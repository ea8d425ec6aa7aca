// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include <orispline/reduce/tolerance_check.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Body rates at which a geodesic the shorter way passes all samples so far within the tolerance, or a few more: in a
/// few balls, between planes across some directions, and not below a least rate.
///
/// A span at body rate ω that passes a sample at L = log(q_i⁻¹q_k), Δt later, within the tolerance ε has
/// ‖ωΔt - L‖ ≤ ε (θ/2)/sin(θ/2), θ = ‖L‖ + ε < π, for that is the largest stretch of the logarithm up to the angle θ;
/// and ‖ωΔt‖ ≥ ‖L‖ - ε at any angle, for exp never stretches. Source: our own derivation, docs/reduce.md.
class FeasibleRates {
 public:
  /// After a sample at the rotation vector `turn` [rad], `elapsed` seconds later, that is passed within the bound
  /// [rad].
  void narrow(const Eigen::Vector3d& turn, double elapsed, double bound);
  /// After sample k of a recording, from its sample i; backward in time where k is before i.
  void narrow(const ToleranceCheck& recording, std::size_t i, std::size_t k);
  /// Whether no geodesic passes all samples.
  [[nodiscard]] bool is_empty() const;
  /// How far a rate is outside at least, across the worst bound [rad/s]; not above 0 inside.
  [[nodiscard]] double distance(const Eigen::Vector3d& rate) const;

 private:
  using Array = Eigen::Array<double, 13, 1>;

  Array lowest_ = Array::Constant(-std::numeric_limits<double>::infinity());
  Array highest_ = Array::Constant(std::numeric_limits<double>::infinity());
  double least_ = 0.0;  ///< norm

  static constexpr int kept_balls = 8;  // more find little more
  Eigen::Array<double, 3, kept_balls> centres_ = Eigen::Array<double, 3, kept_balls>::Zero();
  Eigen::Array<double, 1, kept_balls> radii_ =
      Eigen::Array<double, 1, kept_balls>::Constant(std::numeric_limits<double>::infinity());
  bool are_balls_apart_ = false;

  void narrow_balls(const Eigen::Vector3d& centre, double radius);
  /// How far a rate is outside the balls.
  [[nodiscard]] Eigen::Array<double, 1, kept_balls> beyond_balls(const Eigen::Vector3d& rate) const {
    return (centres_.colwise() - rate.array()).matrix().colwise().norm().array() - radii_;
  }
};

}}  // namespace orispline
