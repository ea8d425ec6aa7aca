// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/io/file_format.hpp>

namespace orispline::cli {

/// With the folders that it is in; it may be there. Error: bad_access.
[[nodiscard]] Expected<void> make_folder(const std::string& folder);

/// Whether make_folder() would make it, or it is there; leaves nothing behind. Error: bad_access.
[[nodiscard]] Expected<void> check_folder(const std::string& folder);

/// Where the outputs of several inputs go: files of the same names in the folder, with the extension of the format
/// where one is asked for, else null. Errors: bad_argument for standard input, for two outputs in one place and for an
/// output that is an input.
[[nodiscard]] Expected<std::vector<std::string>> outputs_in(const std::string& folder,
                                                            std::span<const std::string> inputs,
                                                            const io::FormatInfo* format);

}  // namespace orispline::cli
