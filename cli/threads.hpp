// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "option_text.hpp"

namespace orispline::cli {

inline constexpr std::size_t most_threads = 1024;

/// The number of threads that `--threads` asks for, else one for each core.
[[nodiscard]] Expected<std::size_t> threads_in(const std::optional<std::string>& text);

/// Calls `work` with 0 to count - 1, each on a thread of its own, the first on the caller's; returns when all are done.
void on_threads(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace orispline::cli
