// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <system_error>

#include <orispline/base/abi.hpp>

// What the streams of C do not say of files. Where there is no file system to ask, a path is taken at its word.

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

enum class PlaceKind {
  nothing,
  file,
  folder,
  other,    ///< a device or a pipe
  unknown,  ///< for a reason
};

struct Place {
  PlaceKind kind = PlaceKind::unknown;
  std::error_code fault{};
  std::size_t size = 0;  ///< of a file [bytes], where that can be said
};

/// What is at a path, behind its links.
[[nodiscard]] Place place_at(const std::string& path);

/// The path behind symbolic links, which may lead to what is not there yet; where that cannot be said the path itself.
[[nodiscard]] std::string behind_links(const std::string& path);

/// Gives a file that is written the name of another, with the permissions of that one if it is there. Why not, if so.
[[nodiscard]] std::error_code put_in_place(const std::string& part, const std::string& target);

/// Whether all links of a path lead to where it says, a folder or one below. One that cannot be followed is left to
/// whoever opens the file.
[[nodiscard]] bool stays_within(const std::string& folder, const std::string& file);

/// Whether two files are in one folder, by their names.
[[nodiscard]] bool are_in_one_folder(const std::string& one, const std::string& other);

}}}  // namespace orispline::io
