// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "options/option_text.hpp"

namespace orispline::cli {

inline constexpr std::size_t most_threads = 1024;

/// The number of threads that `--threads` asks for, else one for each core.
[[nodiscard]] Expected<std::size_t> threads_in(const std::optional<std::string>& text);

}  // namespace orispline::cli
