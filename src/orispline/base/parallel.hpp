// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Calls `work(0)` … `work(count - 1)` on up to `threads` threads, this one among them; 0 means one per core.
///
/// Which thread does which part is not fixed: the parts must not depend on each other. What a part throws ends the
/// work, and comes out of here.
ORISPLINE_EXPORT void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}}  // namespace orispline
