// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>

namespace orispline::cli {

// With several inputs all this is gathered first: gathered_output.hpp.

/// Writes a whole document to standard output. Error: bad_access.
[[nodiscard]] Expected<void> print_document(std::string_view text);

/// Writes to standard error as far as that goes: where nobody listens there is nobody to tell.
void tell(std::string_view text);

/// `orispline: warning: …`, one line on standard error.
void warn(std::string_view message);
/// One line for each of them; none twice.
void warn(std::vector<Warning> warnings);

}  // namespace orispline::cli
