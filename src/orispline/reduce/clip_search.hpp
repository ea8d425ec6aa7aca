// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One of the clips of reduce_clips(), whose errors it has, on up to that many threads.
[[nodiscard]] Expected<ClipReduction> clip_with_fewest_keys(const Skeleton& skeleton, const Clip& clip,
                                                            const ClipReduceOptions& options, unsigned threads);

}}  // namespace orispline
