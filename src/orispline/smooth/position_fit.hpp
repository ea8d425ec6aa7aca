// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// fit_smoothing() of positions, in their unit: the smoothing spline of degree 2p-1 by block QR from node to node, with
/// iterated weights for the loss. Of `start` the positions are taken.
[[nodiscard]] SmoothingFit fit_positions(const SmoothingProblem& problem, const SmoothingObjective& objective,
                                         const SmoothingIteration& iteration, const SmoothedNodes* start);

}}  // namespace orispline
