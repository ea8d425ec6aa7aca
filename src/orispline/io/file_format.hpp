// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace orispline::io {

/// The formats of keyframes and samples.
enum class FileFormat {
  csv,    ///< named columns, separated by commas, semicolons, tabs or blanks
  tum,    ///< `t tx ty tz qx qy qz qw`, separated by blanks
  euroc,  ///< time in whole nanoseconds, position, quaternion `w,x,y,z`, and more; separated by commas
  npy,    ///< NumPy array of doubles; of samples only
};

/// What people call a format: `CSV`, `TUM`, `EuRoC`, `NumPy`.
[[nodiscard]] std::string_view title_of(FileFormat format) noexcept;

/// The path that means standard input or standard output.
inline constexpr std::string_view standard_stream = "-";

/// `.csv`, `.tum` or `.npy` at the end of the path, in any case of letters; anything else says nothing. EuRoC files are
/// `.csv` too: only what stands in them tells.
[[nodiscard]] std::optional<FileFormat> format_of_extension(std::string_view path) noexcept;

}  // namespace orispline::io
