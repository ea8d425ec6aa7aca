// SPDX-License-Identifier: Apache-2.0
#include "threads.hpp"

#include <algorithm>
#include <system_error>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace orispline::cli {
namespace {

Expected<std::size_t> thread_count_in(OptionText option) {
  const auto count = count_in(option, 1);
  if (!count || *count > most_threads) return wanted(option, fmt::format("a whole number from 1 to {}", most_threads));
  return *count;
}

}  // namespace

Expected<std::size_t> threads_in(const std::optional<std::string>& text) {
  if (text) return thread_count_in({"--threads", *text});
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads);
}

void on_threads(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::vector<std::thread> others;
  others.reserve(count);
  std::size_t next = 1;
  try {
    for (; next < count; ++next) others.emplace_back(work, next);
  } catch (const std::system_error&) {
    // The system has no more threads: what is left is done here.
  }
  for (; next < count; ++next) work(next);
  if (count > 0) work(0);
  for (std::thread& other : others) other.join();
}

}  // namespace orispline::cli
