// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace orispline::testing_support {

/// How often this thread has called operator new, which this executable replaces.
[[nodiscard]] std::size_t allocations_of_this_thread();

/// How many bytes it has asked for in all.
[[nodiscard]] std::size_t bytes_of_this_thread();

}  // namespace orispline::testing_support
