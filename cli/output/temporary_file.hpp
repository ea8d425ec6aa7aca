// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// Writes a new file `<name>-XXXXXX<extension>` into the folder for temporary files, which only its owner can read, and
/// gives its path. What cannot be written whole is removed, also when the command is interrupted. Error: bad_access.
[[nodiscard]] Expected<std::string> write_temporary_file(std::string_view name, std::string_view extension,
                                                         std::string_view content);

}  // namespace orispline::cli
