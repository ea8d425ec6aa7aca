// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/tune/tension_model.hpp>
#include <orispline/tune/tune.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// An orientation that the curve should pass at u in [0, 1] of a segment.
struct ReferenceSample {
  double u;
  Eigen::Quaterniond orientation;
};

/// An objective with all that it needs.
struct Goal {
  Objective objective = Objective::linearised;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();          ///< [kg m²], body frame; of the torque
  std::vector<std::vector<ReferenceSample>> reference_samples{};  ///< by segment; of the fit
  std::size_t sample_count = 0;
};

/// So much of an objective is rounding of the keys, and no gain.
///
/// The rates of a segment are as uncertain as those of the shortest step beside it.
[[nodiscard]] double rounding_of(const Goal& goal, const Keyframes& keys) noexcept;

/// How many residuals a segment has: the sum of their squares is what it adds to the objective.
[[nodiscard]] std::size_t residual_count(const Goal& goal, std::size_t segment);

/// The residuals of a segment at the values of its own variables, in their order.
///
/// An integral over the segment becomes a sum by Gauss's quadrature: exact for `linearised`, else with a relative error
/// of 3e-14 on steps of a radian.
[[nodiscard]] Eigen::VectorXd residual_values(const TensionSegment& segment, const Goal& goal, std::size_t index,
                                              std::span<const double> values);

/// Their derivatives by the segment's variables, exact, from jets.
[[nodiscard]] Eigen::MatrixXd residual_jacobian(const TensionSegment& segment, const Goal& goal, std::size_t index,
                                                std::span<const double> values);

/// What of a segment changes per unit of a variable that leaves its blending functions as they are.
struct SegmentSlope {
  Increments increments;                                 ///< [rad]
  Eigen::Vector3d from = Eigen::Vector3d::Zero();        ///< how the base turns [rad], in its own frame
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();  ///< where the segment has one
};

/// The Jacobian of the residuals by such variables.
[[nodiscard]] Eigen::MatrixXd residual_jacobian(const TensionSegment& segment, const Goal& goal, std::size_t index,
                                                std::span<const SegmentSlope> slopes);

}}  // namespace orispline
