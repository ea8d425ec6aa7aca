// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// `--json` and `--quiet` of a command that writes a file, as typed.
struct SummaryOptions {
  bool json = false, quiet = false;
};

/// Error (bad_argument): the summary would be in one stream with what is written, `keys` or `samples`.
[[nodiscard]] Expected<void> check_summary(const SummaryOptions& options, std::string_view output,
                                           std::string_view written);

}  // namespace orispline::cli
