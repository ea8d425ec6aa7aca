// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/base/fraction.hpp>
#include <orispline/io/orientation_columns.hpp>
#include <orispline/io/rate_columns.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Order of the quaternion columns of a table without a header.
enum class QuaternionOrder { wxyz, xyzw };

/// A column of a parameter's values.
struct ParameterColumn {
  std::string name;
  std::size_t index = 0;  ///< 0-based
};

/// Which column of a table holds what.
struct KeyColumns {
  std::size_t width = 0;          ///< cells in a row; empty ones may follow
  std::size_t time = 0;           ///< 0-based
  Fraction time_unit{};           ///< [s]
  bool states_time_unit = false;  ///< else the size of the first time decides
  bool counts_frames = false;     ///< the times are numbers of frames, whose length the caller knows
  bool whole_times = false;       ///< times that are not whole numbers are errors
  OrientationForm form{};
  std::vector<NumberColumn> orientation{};  ///< in the order that `orientation_from` takes
  std::optional<VectorColumns> position{};
  RateColumns rates{};
  std::vector<ParameterColumn> parameters{};
  std::vector<std::string> ignored{};  ///< names of the others
};

/// What the names in a header may mean beside the canonical ones.
struct HeaderReading {
  ColumnSearch::Names names{};
  std::span<const std::string> parameters{};  ///< read where a column has the name
  RateReading rates{};
  OrientationReading orientation{};
};

/// Whether the first row of a table names columns: its first cell that is not empty is no number.
[[nodiscard]] ORISPLINE_EXPORT bool is_header(std::span<const std::string_view> row);

/// The columns that a header names, in any order: `t` (or `time`, `timestamp`, `stamp`; with a unit `t_s`, `t_ms`,
/// `t_us`, `t_ns`), the orientation by one of its representations, and where present `px,py,pz` (or `tx,ty,tz`, or
/// `x,y,z`; `px_m`, `px_mm`, `px_cm`, `px_km`), the rates that are asked for (`wx,wy,wz`, `ax,ay,az`, `jx,jy,jz`;
/// `wx_rad_s`, `wx_deg_s`, `wx_body`, `wx_body_rad_s`, `wx_body_deg_s`, `ax_rad_s2`, `jx_rad_s3`, …; on request
/// `wx_world`, …) and parameters. Others are ignored.
///
/// A unit may also stand in brackets behind the name: `time (us)`, `px [mm]`. A name that was mapped brings the unit
/// that it ends in.
///
/// Errors: bad_data for a column that is missing or there twice; bad_argument for a mapping of an unknown name; those
/// of `orientation_columns`.
[[nodiscard]] ORISPLINE_EXPORT Expected<KeyColumns> columns_of_header(std::span<const std::string_view> header,
                                                                      const HeaderReading& reading);

/// `t`, the quaternion, and with 8 columns the position. Error (bad_data): another number of columns.
[[nodiscard]] ORISPLINE_EXPORT Expected<KeyColumns> columns_of_order(std::size_t columns, QuaternionOrder order);

/// Columns without units, side by side.
[[nodiscard]] constexpr VectorColumns three_columns_from(std::size_t first) noexcept {
  return {NumberColumn{first}, NumberColumn{first + 1}, NumberColumn{first + 2}};
}

}}}  // namespace orispline::io
