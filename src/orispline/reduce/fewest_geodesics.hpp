// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/reduce/tolerance_check.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The samples that are keys of `slerp` in the shortest chain of geodesics within the tolerance: no chain through fewer
/// of the samples is.
///
/// Breadth first over the spans from sample to sample that hold all samples between them. Passed over are spans that no
/// rate allows (FeasibleRates, from both ends) and samples too far from the end for a chain as short as is sought
/// (SpansToEnd); that length grows until there is a chain. The bounds cut off nothing that holds. Source: our own
/// derivation, docs/reduce.md.
[[nodiscard]] std::vector<std::size_t> fewest_geodesics(const ToleranceCheck& recording);

}}  // namespace orispline
