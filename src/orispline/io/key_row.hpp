// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline::inline ORISPLINE_ABI::io {

/// One key as a row states it.
struct KeyRow {
  Decimal time;  ///< in the unit of the file
  Eigen::Quaterniond orientation;
  std::optional<Eigen::Vector3d> angles{};  ///< of Euler [rad], in the order of the turns
  Eigen::Vector3d position{};
  std::array<Eigen::Vector3d, 3> rates{};  ///< in the frames of the columns
  std::vector<double> parameters{};
};

/// The key in the row that the table stands at. Errors (bad_data): too few or too many cells; a cell that is no number;
/// numbers that are no orientation; a cell that is empty or not finite, for which `drop_invalid` is the remedy.
[[nodiscard]] Expected<KeyRow> key_row(const TextTable& table, const KeyColumns& columns);

}  // namespace orispline::inline ORISPLINE_ABI::io
