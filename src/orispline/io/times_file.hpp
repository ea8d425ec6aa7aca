// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orispline/io/clock.hpp>

namespace orispline::inline ORISPLINE_ABI::io {

/// The times of a file in its order.
struct TimesList {
  std::vector<double> times{};         ///< relative to the epoch [s]
  std::vector<std::uint32_t> lines{};  ///< 1-based line of each
};

/// Reads sample times, one number a line, in any order; from standard input for `-`.
///
/// A header `t` is allowed, also with a unit (`t_ns`), and `frame`; without one the numbers are seconds. Lines may be
/// times of ISO 8601. The result is relative to `epoch` [s]. Errors: bad_access, bad_data.
[[nodiscard]] ORISPLINE_EXPORT Expected<TimesList> read_times(const std::string& path, const Decimal& epoch,
                                                              const Clock& clock = {});

}  // namespace orispline::inline ORISPLINE_ABI::io
