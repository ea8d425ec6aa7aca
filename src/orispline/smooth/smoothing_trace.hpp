// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/smooth/smoothing.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// The trace of the hat matrix of the smoother, per axis: how many samples' worth of freedom the curve has.
///
/// That of the scalar smoother with the same times [s] and weights [1/rad²], which it is to second order in the angles
/// of the steps, for the transport from node to node is a rotation. By the block recursion of Hutchinson and de Hoog
/// (1985) on the QR factor; linear time.
[[nodiscard]] double hat_trace(std::span<const double> times, std::span<const double> weights, Penalty penalty,
                               double lambda);

}  // namespace orispline::inline ORISPLINE_ABI
