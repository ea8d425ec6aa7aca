// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace orispline::cli {

/// How many characters a line of the terminal has that standard output goes to; absent where it goes elsewhere.
[[nodiscard]] std::optional<std::size_t> terminal_width() noexcept;

}  // namespace orispline::cli
