// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/base/expected.hpp>
#include <orispline/io/column_search.hpp>
#include <orispline/io/orientation_form.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

struct ReadOptions;

/// The columns that state the orientation.
struct OrientationColumns {
  OrientationForm form{};
  ColumnGroup group{};  ///< in the order that `orientation_from` takes; incomplete where the header is
};

/// Every canonical name that an orientation column may have.
[[nodiscard]] std::vector<std::string_view> orientation_names();

/// Finds the columns of one representation.
///
/// Errors: bad_data for several representations to choose from, Euler angles without an order or a unit; bad_argument
/// for options that contradict the header or each other.
[[nodiscard]] Expected<OrientationColumns> orientation_columns(const ColumnSearch& search,
                                                               const OrientationReading& reading);

/// Which angular rates are read.
struct RateReading {
  int orders = 1;      ///< highest order: 0 none, 1 angular velocities, 2 and accelerations, 3 and jerks
  bool world = false;  ///< those in the world frame too, for orders without any in the body frame
};

/// The columns of the rates of one order.
struct RateVector {
  VectorColumns columns;
  Frame frame;
};

/// By order: angular velocity, acceleration, jerk; where there is none there is none of a higher order.
using RateColumns = std::array<std::optional<RateVector>, 3>;

/// Every canonical name that a column of rates may have.
[[nodiscard]] std::vector<std::string_view> rate_names();

/// `wx,wy,wz`, `ax,ay,az`, `jx,jy,jz` in their frames and units.
///
/// Errors (bad_data): one of three columns without the others; accelerations without velocities, jerks without
/// accelerations.
[[nodiscard]] Expected<RateColumns> rate_columns(const ColumnSearch& search, const RateReading& reading);

/// Of the inner quaternions of the segments that leave the keys, and of those that arrive at them.
using InnerColumns = std::array<std::optional<QuaternionColumns>, inner_names.size()>;

/// A column of a parameter's values.
struct ParameterColumn {
  std::string name;
  std::size_t index = 0;  ///< 0-based
};

/// A column with the rest of the times, such as the nanoseconds beside the seconds.
struct RestOfTime {
  std::size_t index = 0;  ///< 0-based
  Fraction unit{};        ///< in units of the other column
};

/// Which column of a table holds what.
struct KeyColumns {
  std::size_t width = 0;  ///< cells in a row; empty ones may follow
  std::size_t time = 0;   ///< 0-based
  std::optional<RestOfTime> rest_of_time{};
  Fraction time_unit{};           ///< [s]
  bool states_time_unit = false;  ///< else the size of the first time decides
  bool counts_frames = false;     ///< the times are numbers of frames, whose length the caller knows
  bool whole_times = false;       ///< times that are not whole numbers are errors
  bool counts_rows = false;       ///< no column has the times: ReadOptions::count_rows
  OrientationForm form{};
  std::vector<NumberColumn> orientation{};  ///< in the order that `orientation_from` takes
  std::optional<VectorColumns> position{};
  RateColumns rates{};
  InnerColumns inner{};
  std::vector<ParameterColumn> parameters{};
  std::vector<std::string> ignored{};  ///< names of the others
  std::string commented_header{};      ///< the comment that named them; empty where a row did
};

/// What the names in a header may mean beside the canonical ones.
struct HeaderReading {
  ColumnNames names{};
  std::span<const std::string> parameters{};  ///< read where a column has the name
  RateReading rates{};
  bool inner_quaternions = false;  ///< whether they are read
  OrientationReading orientation{};
  bool count_rows = false;  ///< no column of times is needed
  bool positions = true;
};

/// The columns of times that a caller names for `t`, such as `sec+nanosec`, each with a unit at the end of its name.
/// Nothing where the header has a column of that very name, or no sign of addition is there. Errors: bad_data for a
/// name that is not there; bad_argument for more than two, or a second one without a unit.
struct TimeColumns {
  std::size_t index;
  Decimal unit;  ///< [s]
  RestOfTime rest;
};
[[nodiscard]] Expected<std::optional<TimeColumns>> two_time_columns(const ColumnSearch& search,
                                                                    const ColumnNames& names);

/// The columns that a header names, in any order: `t` (or `time`, `timestamp`, `stamp`; with a unit `t_s`, `t_ms`,
/// `t_us`, `t_ns`), the orientation by one of its representations, and where present `px,py,pz` (or `tx,ty,tz`, or
/// `x,y,z`; `px_m`, `px_mm`, `px_cm`, `px_km`), the rates that are asked for (`wx,wy,wz`, `ax,ay,az`, `jx,jy,jz`;
/// `wx_rad_s`, `wx_deg_s`, `wx_body`, `wx_body_rad_s`, `wx_body_deg_s`, `ax_rad_s2`, `jx_rad_s3`, …; on request
/// `wx_world`, …), on request inner quaternions (`a_qw,…`, `b_qw,…`), and parameters. Others are ignored.
///
/// A unit may also stand in brackets behind the name: `time (us)`, `px [mm]`. A name that was mapped brings the unit
/// that it ends in.
///
/// Errors: bad_data for a column that is missing or there twice; bad_argument for a mapping of an unknown name; those
/// of `orientation_columns`.
[[nodiscard]] Expected<KeyColumns> columns_of_header(std::span<const std::string_view> header,
                                                     const HeaderReading& reading);

/// `t`, the quaternion, and with 8 columns the position; where rows are counted `t` may be absent. Error (bad_data):
/// another number of columns.
[[nodiscard]] Expected<KeyColumns> columns_of_order(std::size_t columns, const ReadOptions& options);

/// Columns without units, side by side.
[[nodiscard]] constexpr VectorColumns three_columns_from(std::size_t first) noexcept {
  return {NumberColumn{first}, NumberColumn{first + 1}, NumberColumn{first + 2}};
}

/// How the rows of a table are to be read.
struct TableLayout {
  KeyColumns columns{};
  std::vector<std::string> names{};  ///< of all columns: those of the header, else such as one could have
  enum class FirstRow { header, key } first_row = FirstRow::key;
};

/// The names of the columns of a table at its first row: that row, else the comment before it. None where neither names
/// them.
[[nodiscard]] std::vector<std::string_view> header_of(const TextTable& table);

/// `commented_header`: the columns are those that a comment names.
[[nodiscard]] Warning commented_header(std::string_view comment, const std::string& path);

/// The option that asks for something that only a header can give, if any.
[[nodiscard]] std::optional<std::string_view> header_option(const ReadOptions& options);

/// The error (bad_argument) of an option that contradicts the row of the table.
[[nodiscard]] tl::unexpected<Error> misplaced(const TextTable& table, std::string_view option, std::string message);

/// The columns, or what is wrong with them at the row of the table.
[[nodiscard]] Expected<KeyColumns> located(const TextTable& table, Expected<KeyColumns> columns);

}}}  // namespace orispline::io
