// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The recording itself, with the mean rates about each time; times without an orientation take the nearest earlier
/// one.
[[nodiscard]] SmoothedNodes recorded_nodes(const SmoothingProblem& problem);

}}  // namespace orispline
