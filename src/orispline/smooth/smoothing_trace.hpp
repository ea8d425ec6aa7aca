// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/smooth/smoothing.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// The variance of the smoother's value at each time, per axis [rad²], where samples have the variance 1/weight: times
/// the weight it is the diagonal of the hat matrix. Where the weight is 0 it is that of what the others predict.
///
/// By the block recursion of Hutchinson and de Hoog (1985) on the QR factor; linear time.
[[nodiscard]] std::vector<double> node_variances(std::span<const double> times, std::span<const double> weights,
                                                 Penalty penalty, double lambda);

/// The trace of the hat matrix of the smoother, per axis: how many samples' worth of freedom the curve has.
///
/// That of the scalar smoother with the same times [s] and weights [1/rad²], which it is to second order in the angles
/// of the steps, for the transport from node to node is a rotation.
[[nodiscard]] double hat_trace(std::span<const double> times, std::span<const double> weights, Penalty penalty,
                               double lambda);

}  // namespace orispline::inline ORISPLINE_ABI
