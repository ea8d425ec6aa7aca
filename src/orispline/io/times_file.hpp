// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/io/decimal.hpp>

namespace orispline::io {

/// Reads sample times, one number a line, in any order; from standard input for `-`.
///
/// A header `t` is allowed, also with a unit (`t_ns`); without one the numbers are seconds. The result is relative to
/// `epoch` [s]. Errors: bad_access, bad_data.
[[nodiscard]] Expected<std::vector<double>> read_times(const std::string& path, const Decimal& epoch);

}  // namespace orispline::io
