// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/io/key_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// The times of a file in its order.
struct TimesList {
  std::vector<double> times{};         ///< relative to the epoch [s]
  std::vector<std::uint32_t> lines{};  ///< 1-based line of each
  std::vector<Warning> warnings{};     ///< `time_unit_by_size`, `commented_header`
};

/// Reads sample times in any order: one number a line, or the times of any table, such as a file of keys.
///
/// A header names the column of times: `t`, `time_ns`, …, or what the options state for `t`. Tables without a header
/// are those of TUM and EuRoC, and of CSV where the options state an order. Times whose unit is not stated are seconds,
/// from 1e11 on what a clock counts; frames and times of ISO 8601 are those of the options' clock. The result is
/// relative to `epoch` [s]. Errors: bad_access, bad_data.
[[nodiscard]] ORISPLINE_EXPORT Expected<TimesList> read_times(const Input& input, const Decimal& epoch,
                                                              const ReadOptions& options = {});

}}}  // namespace orispline::io
