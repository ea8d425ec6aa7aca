// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/curve/track.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/sample_columns.hpp>

namespace orispline::inline ORISPLINE_ABI::io {

/// Writes keys into an open file, which is left to be closed.
///
/// A track that carries its table is written as its file has it, with its settings in their columns, where the format
/// has tables. Every other one is written in these columns, but with positions and settings where it has them and with
/// no more rates than its keys have; quaternions keep the digits of its file.
///
/// Errors: bad_access; bad_argument for what the format cannot hold, several tracks among it; bad_data with the key.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> write_tracks(OutputFile& file, std::span<const Track> tracks,
                                                           const SampleColumns& columns);

}  // namespace orispline::inline ORISPLINE_ABI::io
