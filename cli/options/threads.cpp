// SPDX-License-Identifier: Apache-2.0
#include "options/threads.hpp"

#include <algorithm>
#include <thread>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

Expected<std::size_t> thread_count_in(OptionText option) {
  const auto count = count_in(option, 1);
  if (!count || *count > most_threads) return wanted(option, formatted("a whole number from 1 to {}", most_threads));
  return *count;
}

}  // namespace

Expected<std::size_t> threads_in(const std::optional<std::string>& text) {
  if (text) return thread_count_in({"--threads", *text});
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads);
}

}  // namespace orispline::cli
