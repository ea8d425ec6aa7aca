// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <latch>
#include <thread>
#include <vector>

namespace orispline::testing_support {

/// Calls `work(0)` … `work(count - 1)` on threads of their own, which start at the same moment.
template <class Work>
void together(std::size_t count, const Work& work) {
  std::latch start(static_cast<std::ptrdiff_t>(count));
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < count; ++i)
    threads.emplace_back([&start, &work, i] {
      start.arrive_and_wait();
      work(i);
    });
}

}  // namespace orispline::testing_support
