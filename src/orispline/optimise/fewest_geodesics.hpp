// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/optimise/recording.hpp>

namespace orispline::optimise {

/// The samples that are keys of `slerp` in the shortest chain of geodesics within the tolerance: no chain through fewer
/// of the samples is.
///
/// Breadth first over the spans from sample to sample that hold all samples between them. The look-ahead from a sample
/// ends where no later span can hold: a span at body rate ω that passes a sample at L = log(q_i⁻¹q_k), Δt later, within
/// the tolerance ε has ‖ωΔt - L‖ ≤ ε (θ/2)/sin(θ/2), θ = ‖L‖ + ε < π, for that is the largest stretch of the logarithm
/// up to the angle θ. Where the planes around these balls of rates leave no rate, the bound has cut off nothing.
/// Source: our own derivation, docs/reduce.md.
[[nodiscard]] std::vector<std::size_t> fewest_geodesics(const Recording& recording);

}  // namespace orispline::optimise
