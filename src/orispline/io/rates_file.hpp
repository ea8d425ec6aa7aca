// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/base/expected.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/key_input.hpp>
#include <orispline/io/output_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Reads the rates of a gyro from a table with a header: the time, and `wx,wy,wz` of the body in any of their units.
/// Rows without a number in one of these three are none.
///
/// Of the options those count that concern times and their order, frames and the names of these columns; `session` only
/// where the file has several recordings. Errors: those of check_frames(); bad_access; bad_data for columns that are
/// missing, times that do not increase, and no rates at all; bad_argument for a recording that there is not.
[[nodiscard]] ORISPLINE_EXPORT Expected<RateRows> read_rates(Input file, const ReadOptions& options = {});
/// Those of a file that was opened before.
[[nodiscard]] ORISPLINE_EXPORT Expected<RateRows> read_rates(KeyInput input, const ReadOptions& options = {});

/// Whether a file has rates of the body and no orientations, as its header says: it is the recording of a gyro.
[[nodiscard]] ORISPLINE_EXPORT bool holds_rates_alone(KeyInput& input, const ReadOptions& options = {});

/// Writes `t,wx,wy,wz` in s and rad/s into an open file, which is left to be closed. Error: bad_access.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> write_rates(OutputFile& file, const RateRows& rows);

}}}  // namespace orispline::io
