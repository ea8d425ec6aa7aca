// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline::io {

/// A track as a file holds it, with what reading did to it.
struct TrackFile {
  Track track{};
  std::vector<Eigen::Quaterniond> as_read{};  ///< with the norms and signs of the file; only if asked for
  const FormatInfo* format = &csv_format;
  RepairReport repairs{};
  KeyTable table{};                                   ///< the cells of each key; only if asked for
  std::vector<std::string> ignored_columns{};         ///< that nothing was read from
  std::vector<std::string> rates_of_unknown_frame{};  ///< those of them that are angular velocities in no known frame

  /// A key as it should be written: with the digits of the file and the sign of the key, where the key is what the file
  /// has at this index and its norm there is 1; else the key itself. Precondition: read with `keep_as_read`.
  [[nodiscard]] Eigen::Quaterniond written(const Eigen::Quaterniond& key, std::size_t index) const;
};

/// Reads the track of a file, or of standard input for `-`, and checks its keys.
///
/// Errors name the file, the line and the column or the key: those of read_keys() and of Keyframes::make().
[[nodiscard]] Expected<TrackFile> read_track(const std::string& path, const ReadOptions& options = {},
                                             Signs signs = Signs::shortest);

/// What was read of a file, with its keys when they have been checked.
[[nodiscard]] TrackFile track_file(KeyFile file, Keyframes keys);

}  // namespace orispline::io
