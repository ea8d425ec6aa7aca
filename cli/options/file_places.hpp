// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/io/file_format.hpp>

namespace orispline::cli {

/// The extension of texts of any format.
inline constexpr std::string_view any_text = ".txt";

/// A file that the command reads or writes besides, and its name in a message: `INPUT`.
struct OtherFile {
  std::string_view name;
  std::string path;
};

/// Whether both paths lead to one file, through links too. Streams are never the same file.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// What is lost where this file is written: `INPUT`, or `a part of INPUT` where that is a .gltf file which names the
/// other one, such as its buffer. Empty if none of them is.
[[nodiscard]] std::string lost_with(const std::string& path, const std::vector<OtherFile>& others);

/// Error (bad_argument): the file of this option is one of those that are read, which would be lost.
[[nodiscard]] Expected<void> check_output_apart(std::string_view option, const std::string& output,
                                                const std::vector<OtherFile>& read);

/// Error (bad_argument): a file whose name ends as files of other kinds do; `extensions` are those that fit, with their
/// dots, in any case of letters. Names without an extension fit. `cure`: what else would help.
[[nodiscard]] Expected<void> check_extension(std::string_view option, const std::string& output,
                                             std::vector<std::string_view> extensions, std::string_view cure = {});

/// Whether a name ends as those of files do of which this is true: `has_name_of(&io::FormatInfo::is_read, path)`.
[[nodiscard]] bool has_name_of(bool (io::FormatInfo::*is_so)() const noexcept, const std::string& path);

/// Whether a name ends in that extension, which has its dot, in any case of letters.
[[nodiscard]] bool has_extension(const std::string& path, std::string_view extension);

}  // namespace orispline::cli
