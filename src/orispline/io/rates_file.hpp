// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/base/expected.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Reads the rates of a gyro from a table with a header: the time, and `wx,wy,wz` of the body in any of their units.
/// Rows without a number in one of these three are none.
///
/// Of the options those count that concern times, frames and the names of these columns. Errors: those of
/// check_frames(); bad_access; bad_data for columns that are missing, times that do not increase, and no rates at all.
[[nodiscard]] ORISPLINE_EXPORT Expected<RateRows> read_rates(const Input& input, const ReadOptions& options = {});

}}}  // namespace orispline::io
