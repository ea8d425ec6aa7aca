// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <orispline/curve/track.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/sample_columns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Whether a file with these columns says which curve the keys are for: the format has comments, and room for the rates
/// that are part of them.
[[nodiscard]] ORISPLINE_EXPORT bool states_recipe(const Track& track, const SampleColumns& columns);

/// `recipe_not_stated`: the keys are for the curve of a method, and a file with these columns cannot say so.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Warning> recipe_not_stated(const Track& track,
                                                                        const SampleColumns& columns,
                                                                        std::string_view file);

/// Writes keys into an open file, which is left to be closed.
///
/// A track that carries its table is written as its file has it, with its settings in their columns, where the format
/// has tables. Every other one is written in these columns, but with positions and settings where it has them and with
/// no more rates than its keys have; quaternions keep the digits of its file. Where states_recipe(), the track's recipe
/// is a comment above.
///
/// Errors: bad_access; bad_argument for what the format cannot hold, several tracks among it; bad_data with the key.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> write_tracks(OutputFile& file, std::span<const Track> tracks,
                                                           const SampleColumns& columns);

}}}  // namespace orispline::io
