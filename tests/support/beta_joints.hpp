// SPDX-License-Identifier: Apache-2.0
#pragma once

// Beta curves taken apart at their joints, as the paper by He et al. (2022) looks at them.

#include <map>
#include <string>
#include <vector>

#include <support/specimens.hpp>
#include <support/typed_curves.hpp>

namespace orispline::testing_support {

using Parameters = std::map<std::string, std::vector<double>, std::less<>>;

/// The shape parameters of both examples of the paper.
inline const Parameters beta_of_the_examples{{"beta1", {1.0}}, {"beta2", {0.5}}};

inline CubicBezierCurve beta(const Keyframes& keys, const Parameters& parameters) {
  return typed_curve<families::Beta>(keys, {.parameters = parameters});
}

/// The control points q_{i,0} … q_{i,3} of all segments, a joint once.
inline std::vector<Eigen::Quaterniond> control_points(const CubicBezierCurve& curve) {
  std::vector<Eigen::Quaterniond> points{curve.polygon().bases[0]};
  for (const Eigen::Vector3d& increment : curve.polygon().increments)
    points.push_back(points.back() * exp<double>(increment));
  return points;
}

/// s' and s'' of both segments at a joint, as in the paper: in the local parameter.
struct Joint {
  Eigen::Vector4d before1, after1, before2, after2;
};

template <Curve C>
[[nodiscard]] Joint joint_of(const C& curve, std::size_t joint) {
  const double t = curve.knots().times()[joint];
  const auto before = quaternion_derivatives(curve, t, joint - 1), after = quaternion_derivatives(curve, t, joint);
  return {before[1], after[1], before[2], after[2]};
}

/// Size of the paper's second constraint left over: s''(0) - β₁² s''(1) - δ s'(1), δ = β₂ in the paper.
inline double g2_residual(const Joint& j, double beta1, double delta) {
  return (j.after2 - beta1 * beta1 * j.before2 - delta * j.before1).norm();
}

/// The same relative to s''.
inline double relative_g2_residual(const Joint& j, double beta1, double beta2) {
  return g2_residual(j, beta1, beta2) / j.after2.norm();
}

/// β₁ and β₂ of their own for every point.
inline Parameters mixed_betas(std::size_t points, std::uint64_t seed) {
  Dice dice(seed);
  Parameters p;
  for (std::size_t i = 0; i < points; ++i) {
    p["beta1"].push_back(dice.between(0.5, 2.0));
    p["beta2"].push_back(dice.between(-1.0, 6.0));
  }
  return p;
}

/// Keys at t = 0, 1, 2 …, where derivatives in time are those in the local parameter.
inline KeyframeData at_whole_times(KeyframeData data) {
  for (std::size_t i = 0; i < data.times.size(); ++i) data.times[i] = static_cast<double>(i);
  return data;
}

/// The least residual that any δ leaves, and that δ.
inline std::pair<double, double> best_delta(const Joint& j, double beta1) {
  const Eigen::Vector4d missing = j.after2 - beta1 * beta1 * j.before2;
  const double delta = missing.dot(j.before1) / j.before1.squaredNorm();
  return {delta, g2_residual(j, beta1, delta)};
}

}  // namespace orispline::testing_support
