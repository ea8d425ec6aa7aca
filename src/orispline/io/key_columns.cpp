// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_columns.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/time_column.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::array<std::string_view, 3> position_names{"px", "py", "pz"};
/// What others call them, if all three are there.
constexpr std::array<std::array<std::string_view, 3>, 2> other_position_names{{{"tx", "ty", "tz"}, {"x", "y", "z"}}};

constexpr std::array lengths{Unit{""}, Unit{"_m"}, Unit{"_mm", 1.0, 1000.0}, Unit{"_cm", 1.0, 100.0},
                             Unit{"_km", 1000.0, 1.0}};

/// Every name that a mapping may be for.
std::vector<std::string_view> canonical_names(std::span<const std::string> parameters) {
  std::vector<std::string_view> names{time_name};
  const auto append = [&names](const auto& more) { names.insert(names.end(), more.begin(), more.end()); };
  append(orientation_names());
  append(position_names);
  append(rate_names());
  append(parameters);
  return names;
}

/// An error when a mapping is for a name that no column can have.
Expected<void> check_mappings(const HeaderReading& reading) {
  const auto wanted = canonical_names(reading.parameters);
  for (const auto& [canonical, name] : reading.names)
    if (std::ranges::find(wanted, canonical) == wanted.end())
      return bad_option("columns", formatted("found {}={}, wanted a name that is read before the sign: {}", canonical,
                                             name, joined(wanted, ", ")));
  return {};
}

/// What every table must have.
struct RequiredColumns {
  std::size_t time;
  OrientationColumns orientation;
};

Expected<RequiredColumns> required_columns(const ColumnSearch& search, const OrientationReading& reading) {
  auto time = search.column(time_name, [](std::string_view name) { return time_unit_of(name).has_value(); });
  if (time && !*time) time = search.column(time_name, counts_frames);
  if (!time) return tl::unexpected(time.error());
  auto orientation = orientation_columns(search, reading);
  if (!orientation) return tl::unexpected(std::move(orientation.error()));
  auto missing = orientation->group.missing;
  if (!*time) missing.insert(missing.begin(), time_name);
  if (missing.empty()) return RequiredColumns{**time, std::move(*orientation)};
  return mended_by("columns", formatted("no column {}, found {}", joined(missing, ", "), search.found_names()));
}

Expected<std::vector<ParameterColumn>> parameter_columns(const ColumnSearch& search,
                                                         std::span<const std::string> names) {
  std::vector<ParameterColumn> columns;
  for (const std::string& name : names) {
    const auto index = search.column(name, [&name](std::string_view column) { return column == name; });
    if (!index) return tl::unexpected(index.error());
    if (*index) columns.push_back({name, **index});
  }
  return columns;
}

Expected<std::optional<VectorColumns>> position_columns(const ColumnSearch& search) {
  auto columns = search.vector(position_names, lengths, lengths);
  for (const auto& names : other_position_names) {
    if (!columns || *columns) return columns;
    if (std::ranges::any_of(names, [&](std::string_view name) { return search.is_mapped(name); })) continue;
    const auto others = search.group(names, lengths, lengths);
    if (!others || others->is_complete()) columns = search.vector(names, lengths, lengths);
  }
  return columns;
}

/// The names of the columns that nothing is read from.
std::vector<std::string> ignored_names(std::span<const std::string_view> header, const KeyColumns& columns) {
  std::vector<bool> is_read(header.size(), false);
  const auto mark = [&is_read](const auto& numbers) {
    for (const auto& column : numbers) is_read[column.index] = true;
  };
  is_read[columns.time] = true;
  mark(columns.orientation);
  if (columns.position) mark(*columns.position);
  for (const auto& rate : columns.rates)
    if (rate) mark(rate->columns);
  mark(columns.parameters);
  std::vector<std::string> ignored;
  for (std::size_t i = 0; i < header.size(); ++i)
    if (!is_read[i] && !header[i].empty()) ignored.emplace_back(header[i]);
  return ignored;
}

bool begins_like_number(std::string_view cell) {
  return std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
}

}  // namespace

bool is_header(std::span<const std::string_view> row) {
  const auto first = std::find_if(row.begin(), row.end(), [](std::string_view cell) { return !cell.empty(); });
  return first != row.end() && !begins_like_number(*first) && !number_of(*first);
}

Expected<KeyColumns> columns_of_header(std::span<const std::string_view> header, const HeaderReading& reading) {
  while (!header.empty() && header.back().empty()) header = header.first(header.size() - 1);
  if (auto checked = check_mappings(reading); !checked) return tl::unexpected(std::move(checked.error()));
  const ColumnSearch search(header, reading.names);
  auto required = required_columns(search, reading.orientation);
  if (!required) return tl::unexpected(std::move(required.error()));
  const auto position = position_columns(search);
  if (!position) return tl::unexpected(position.error());
  auto rates = rate_columns(search, reading.rates);
  if (!rates) return tl::unexpected(std::move(rates.error()));
  auto parameters = parameter_columns(search, reading.parameters);
  if (!parameters) return tl::unexpected(std::move(parameters.error()));

  const std::string_view time = search.plain_name(required->time);
  const TimeUnit unit = time_unit_of(time).value_or(time_unit_at_end_of(time));
  KeyColumns columns{.width = header.size(),
                     .time = required->time,
                     .time_unit = unit.seconds,
                     .states_time_unit = unit.is_stated,
                     .counts_frames = counts_frames(time),
                     .form = required->orientation.form,
                     .orientation = std::move(required->orientation.group.columns),
                     .position = *position,
                     .rates = *rates,
                     .parameters = std::move(*parameters)};
  columns.ignored = ignored_names(header, columns);
  return columns;
}

Expected<KeyColumns> columns_of_order(std::size_t columns, QuaternionOrder order) {
  if (columns != 5 && columns != 8)
    return failure(ErrorCode::bad_data,
                   formatted("found {} columns without a header, wanted 5 (t and the quaternion) or 8 (px, py, pz "
                             "after them)",
                             columns));
  KeyColumns result{.width = columns, .orientation = {{1}, {2}, {3}, {4}}};
  if (order == QuaternionOrder::xyzw) result.orientation = {{4}, {1}, {2}, {3}};
  if (columns == 8) result.position = three_columns_from(5);
  return result;
}

}}}  // namespace orispline::io
