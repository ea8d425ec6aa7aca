// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/rotation_value.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/file_option_words.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::string_view wanted_rotation =
    "qw, qx, qy, qz, or angles such as roll_deg, pitch_deg, yaw_deg, or r11, …, r33, or rx, ry, rz [rad]";

/// Numbers with their names.
struct NamedCells {
  std::vector<std::string_view> names, cells;
  enum class Others { ignored, refused } others = Others::refused;  // that are no part of a rotation
};

Expected<OrientationNumbers> numbers_in(std::span<const NumberColumn> columns, const NamedCells& given) {
  OrientationNumbers numbers(static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const NumberColumn& column = columns[i];
    const std::string_view cell = column.index < given.cells.size() ? given.cells[column.index] : "";
    const auto number = number_of(cell);
    if (!number || !std::isfinite(*number))
      return failure(ErrorCode::bad_argument, formatted("found {}={}, wanted a number", given.names[column.index],
                                                        cell.empty() ? "nothing" : printable(cell)));
    numbers[static_cast<Eigen::Index>(i)] = *number * column.numerator / column.denominator;
  }
  return numbers;
}

Expected<Eigen::Quaterniond> unit_quaternion(const Eigen::Quaterniond& q) {
  const double norm = q.coeffs().stableNorm();
  if (std::abs(norm - 1.0) <= loose_norm_limit) return q.normalized();
  return failure(ErrorCode::bad_argument,
                 formatted("the quaternion has norm {:.6g}, wanted 1 within {:g}", norm, loose_norm_limit));
}

/// The rotation in columns of these names.
Expected<Eigen::Quaterniond> rotation_of(const NamedCells& given, const OrientationReading& reading) {
  const ColumnNames none;
  const ColumnSearch search(given.names, none);
  const auto found = orientation_columns(search, reading);
  if (!found) return tl::unexpected(found.error());
  const bool has_others = found->group.columns.size() < given.names.size();
  if (!found->group.is_complete() || (has_others && given.others == NamedCells::Others::refused))
    return failure(ErrorCode::bad_argument, formatted("found {}, wanted {}", search.found_names(), wanted_rotation));
  return numbers_in(found->group.columns, given)
      .and_then([&](const OrientationNumbers& numbers) { return orientation_from(numbers, found->form); })
      .and_then(unit_quaternion);
}

/// The only row of a file behind its header.
Expected<Eigen::Quaterniond> rotation_in_file(const std::string& path) {
  auto table = TextTable::open(path);
  if (!table) return tl::unexpected(std::move(table.error()));
  std::vector<std::vector<std::string>> rows;
  for (auto more = table->next(); !more || *more; more = table->next()) {
    if (!more) return tl::unexpected(more.error());
    if (rows.empty() && !is_header(table->cells()))
      return failure(ErrorCode::bad_data, formatted("found no header, wanted one with {}", wanted_rotation),
                     table->here());
    if (rows.size() == 2)
      return failure(ErrorCode::bad_data, "found a second row of numbers, wanted one rotation", table->here());
    const auto cells = table->cells().first(width_of(table->cells()));
    rows.emplace_back(cells.begin(), cells.end());
  }
  if (rows.size() < 2)
    return failure(ErrorCode::bad_data,
                   formatted("found no numbers, wanted a header with {} and one row", wanted_rotation), {.file = path});
  const NamedCells given{
      {rows[0].begin(), rows[0].end()}, {rows[1].begin(), rows[1].end()}, NamedCells::Others::ignored};
  return rotation_of(given, {}).map_error([&](Error error) {
    if (error.code == ErrorCode::bad_argument) error.code = ErrorCode::bad_data;
    error.where.file = path;
    return error;
  });
}

Expected<Eigen::Quaterniond> rotation_by_names(std::string_view text) {
  NamedCells given;
  OrientationReading reading;
  for (const std::string_view piece : pieces_of(text, ',')) {
    const std::size_t equals = piece.find('=');
    if (equals == 0 || equals == piece.npos)
      return failure(ErrorCode::bad_argument, formatted("found {}, wanted NAME=NUMBER", in_quotes(piece)));
    const std::string_view name = piece.substr(0, equals), value = piece.substr(equals + 1);
    if (name == "euler") {
      const auto order = euler_in("euler", value);
      if (!order) return tl::unexpected(order.error());
      reading.euler = *order;
      continue;
    }
    given.names.push_back(name);
    given.cells.push_back(value);
  }
  return rotation_of(given, reading);
}

}  // namespace

Expected<Eigen::Quaterniond> rotation_value(std::string_view option, std::string_view text) {
  const bool is_by_names = text.find('=') != text.npos;
  if (!is_by_names && (text.empty() || text == standard_stream))
    return bad_option(
        option, formatted("found '{}', wanted NAME=NUMBER,... with {}, or a file of one row", text, wanted_rotation));
  auto rotation = is_by_names ? rotation_by_names(text) : rotation_in_file(std::string(text));
  if (rotation) return rotation;
  Error& error = rotation.error();
  if (error.code == ErrorCode::bad_data && is_by_names) error.code = ErrorCode::bad_argument;
  if (error.remedy == "euler") error.message += "; here `euler=ZXZ` beside the angles";
  error.option = option;
  error.remedy.clear();
  return tl::unexpected(std::move(error));
}

}}}  // namespace orispline::io
