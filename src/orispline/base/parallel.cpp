// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace orispline::inline ORISPLINE_ABI {

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> others;  // joined when they go out of scope
  try {
    for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) others.emplace_back(run);
  } catch (const std::system_error&) {
    // The system has no more threads: those that there are do the rest.
  }
  run();
}

}  // namespace orispline::inline ORISPLINE_ABI
