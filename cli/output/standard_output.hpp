// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// Writes a whole document to standard output. Error: bad_access.
[[nodiscard]] Expected<void> print_document(std::string_view text);

/// Writes to standard error as far as that goes: where nobody listens there is nobody to tell.
void tell(std::string_view text) noexcept;

/// `orispline: warning: …`, one line on standard error.
void warn(std::string_view message);
/// The same where there is something to say.
void warn_if_any(const std::optional<std::string>& message);

}  // namespace orispline::cli
