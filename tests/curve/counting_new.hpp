// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace orispline::testing_support {

/// How often this thread has called operator new, which this executable replaces.
[[nodiscard]] std::size_t allocations_of_this_thread();

}  // namespace orispline::testing_support
