// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/smooth/smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The smoother of one axis, which that of orientations is to second order in the angles of the steps, for the
/// transport from node to node is a rotation.
struct ScalarSmoother {
  std::span<const double> times;    ///< [s]
  std::span<const double> weights;  ///< [1/rad²]
  Penalty penalty{};
  double lambda = 1.0;
  std::span<const double> relative_lambdas{};  ///< as of SmoothingProblem
  std::span<const double> rate_weights{};      ///< [s²/rad²], of a gyro; empty without one
  double drift = 0.0;                          ///< as of SmoothingObjective, of its bias; 0: it has none

  /// Of the nodes about an interval, with the root of its λ.
  template <int P>
  [[nodiscard]] Eigen::Matrix<double, P, 2 * P> link(std::size_t interval) const;
};

/// The variance of the smoother's value at each time, per axis [rad²], where samples have the variance 1/weight: times
/// the weight it is the diagonal of the hat matrix. Where the weight is 0 it is that of what the others predict.
///
/// By the block recursion of Hutchinson and de Hoog (1985) on the QR factor; linear time.
[[nodiscard]] std::vector<double> node_variances(const ScalarSmoother& smoother);

/// How much of what the penalty keeps small the samples determine in each interval, per axis: 0 where they say nothing
/// of it, p where they say all. It is found by the same recursion.
[[nodiscard]] std::vector<double> interval_freedoms(const ScalarSmoother& smoother);

/// The trace of the hat matrix of the smoother, per axis: how many samples' worth of freedom the curve has.
[[nodiscard]] double hat_trace(const ScalarSmoother& smoother);

}}  // namespace orispline
