// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>

namespace orispline::testing_support {

/// Of operator new, which this executable replaces: how many more allocations of all threads succeed; negative: all.
void allow_allocations(long count) noexcept;

enum class Ending { done, out_of_memory };

/// The work with memory for so many allocations. A function that is noexcept and wants one more ends the program.
template <class Work>
[[nodiscard]] Ending with_allocations(long count, Work work) {
  try {
    allow_allocations(count);
    work();
    allow_allocations(-1);
    return Ending::done;
  } catch (const std::bad_alloc&) {
    allow_allocations(-1);
    return Ending::out_of_memory;
  }
}

}  // namespace orispline::testing_support
