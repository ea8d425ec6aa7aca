// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What to say of a file that begins with this row and is of a kind which people have keys in, but which is not read:
/// what it is, and how its keys become a table. Absent for all else.
[[nodiscard]] std::optional<std::string> other_kind(std::string_view first_row);

}}}  // namespace orispline::io
