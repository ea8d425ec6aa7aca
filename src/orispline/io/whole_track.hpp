// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <orispline/curve/family.hpp>
#include <orispline/io/file_option.hpp>
#include <orispline/io/track_file.hpp>

// Keys with all that they have, for callers who do not know yet which curve they are for.

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// What the caller knows of methods, and how he says what is wrong.
struct CurvesOfKeys {
  std::span<const FamilyInfo> families;  ///< all that there are
  /// That of the method which keys of this name are for; null where they name none.
  Expected<std::shared_ptr<const FamilyInfo>> (*named)(const Recipe& recipe, std::string_view file);
  std::string (*words)(const Error& error);  ///< for people
};

/// Reads keys with all columns that any method takes. Where not all keys have these, with those of the method that the
/// file names, and the warning `columns_left_out`. Errors: those of read_track().
[[nodiscard]] ORISPLINE_EXPORT Expected<TrackFile> read_whole_track(const Input& input, Reading reading,
                                                                    const CurvesOfKeys& curves);

/// Writes keys with all that they have and the format has columns for, but for those that say where they go. Gives the
/// warnings `recipe_not_stated`, and `not_written` of what is left out. Errors: those of write_tracks().
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<Warning>> write_whole_track(OutputFile& file, Track track,
                                                                                SampleColumns columns);

}}}  // namespace orispline::io
