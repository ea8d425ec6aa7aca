// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Those at these places.
[[nodiscard]] RateRows rows_at(const RateRows& rows, const std::vector<std::uint32_t>& places);

/// Leaves the recording that `session` asks for. A file that has one is read whole, whichever is asked for: it lies
/// beside a file that has several. Errors: bad_argument for a recording that there is not; bad_data for several that
/// sorting would mix.
[[nodiscard]] Expected<void> choose_session(RateRows& rows, const ReadOptions& options, const std::string& path);

/// Brings rates into the order of their times, as `sort` and `drop_duplicates` ask for. Error (bad_data): times that do
/// not increase, with the option that mends it.
[[nodiscard]] Expected<void> put_in_order(RateRows& rows, const ReadOptions& options, const std::string& path);

}}}  // namespace orispline::io
