// SPDX-License-Identifier: Apache-2.0
// Ground truth of the EuRoC data sets of flying robots: time [ns], position, quaternion `w,x,y,z`, and more.
#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_columns.hpp>
#include <orispline/io/text_row.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace { namespace euroc {

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr int nanoseconds = 9;  // per second, as a power of ten

constexpr std::array<std::string_view, 8> names{"t_ns", "px", "py", "pz", "qw", "qx", "qy", "qz"};
/// The names as the data sets have them, without their units.
constexpr std::array<std::string_view, names.size()> names_there{"timestamp", "p_RS_R_x", "p_RS_R_y", "p_RS_R_z",
                                                                 "q_RS_w",    "q_RS_x",   "q_RS_y",   "q_RS_z"};

/// A name without blanks around it and without the unit behind it. Time alone may only be in nanoseconds.
std::string_view plain_name(std::string_view cell) {
  const std::size_t begin = std::min(cell.find_first_not_of(" \t"), cell.size());
  cell.remove_prefix(begin);
  if (cell.starts_with("timestamp [ns]") || cell.starts_with("timestamp_ns")) return "timestamp";
  if (cell.starts_with("timestamp [")) return cell;
  return cell.substr(0, cell.find_first_of(" \t["));
}

/// Whether a header names the columns in their order. Units in brackets may be left out; other columns may follow.
bool names_them(std::span<const std::string_view> cells) {
  return cells.size() >= names_there.size() &&
         std::equal(names_there.begin(), names_there.end(), cells.begin(),
                    [](std::string_view name, std::string_view cell) { return plain_name(cell) == name; });
}

/// Whether a comment names the columns in their order.
bool names_them(std::string_view comment) {
  comment.remove_prefix(std::min(comment.find_first_not_of("# \t"), comment.size()));
  std::array<std::string_view, names_there.size()> cells;
  for (std::string_view& cell : cells) {
    cell = comment.substr(0, comment.find(','));
    comment.remove_prefix(std::min(cell.size() + 1, comment.size()));
  }
  return names_them(cells);
}

/// Times of this many digits are nanoseconds of the Unix epoch.
bool has_times_of_today(const TextTable& table) {
  constexpr std::size_t digits_of_nanoseconds = 18;
  return width_of(table.cells()) >= names.size() && table.cells()[0].size() > digits_of_nanoseconds &&
         table.cells()[0].find_first_not_of("0123456789") == std::string_view::npos;
}

/// Where the caller names the columns, a header is not believed.
Likeness likeness(const TextTable& table, const ReadOptions& options) {
  if (options.columns.empty() && (names_them(table.comment()) || names_them(table.cells()))) return Likeness::certain;
  return has_times_of_today(table) ? Likeness::possible : Likeness::none;
}

Expected<TableLayout> layout(const TextTable& table, const ReadOptions& options) {
  if (options.order)
    return misplaced(table, "order",
                     "found an EuRoC file, whose columns are always time, position, quaternion w,x,y,z, wanted CSV");
  if (const auto option = header_option(options))
    return misplaced(table, *option, "found an EuRoC file, whose columns are fixed, wanted CSV");
  const std::size_t width = width_of(table.cells());
  if (width < names.size())
    return failure(ErrorCode::bad_data,
                   formatted("found {} column{}, wanted at least 8 (time, position, quaternion w,x,y,z)", width,
                             width == 1 ? "" : "s"),
                   table.here());
  TableLayout layout{
      .columns = {.width = width,
                  .time_unit = Decimal::power_of_ten(-nanoseconds),
                  .states_time_unit = true,
                  .whole_times = true,
                  .orientation = {{4}, {5}, {6}, {7}},
                  .position = three_columns_from(1)},
      .names = {names.begin(), names.end()},
      .first_row = is_header(table.cells()) ? TableLayout::FirstRow::header : TableLayout::FirstRow::key};
  if (width > names.size()) layout.columns.ignored = {formatted("columns {} to {}", names.size() + 1, width)};
  for (std::size_t i = names.size(); i < width; ++i) layout.names.push_back(formatted("column{}", i + 1));
  return layout;
}

std::string header(const SampleColumns&, std::size_t) {
  return "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n";
}

RowNumbers numbers(const Sample& sample, const SampleColumns& columns) {
  const Eigen::Quaterniond orientation = written_orientation(sample.motion.orientation, columns);
  RowNumbers numbers;
  numbers.add(sample.linear_motion.position);
  numbers.add(orientation.w());
  numbers.add(Eigen::Vector3d(orientation.vec()));
  return numbers;
}

void row(std::string& bytes, const Decimal& time, std::span<const double> numbers) {
  append_text_row(bytes, time, numbers, ',');
}

}  // namespace euroc

}  // namespace

constinit const FormatInfo euroc_format{
    .id = "euroc",
    .title = "EuRoC",
    .file = "an EuRoC file",
    .summary = "time in whole nanoseconds, position, quaternion `w,x,y,z`, and more; separated by commas",
    .extensions = euroc::extensions,
    .holds = {.always_positions = true, .comments = true},
    .reading = {.likeness = euroc::likeness, .layout = euroc::layout, .delimiter = Delimiter::comma},
    .writing = {.header = euroc::header,
                .numbers = euroc::numbers,
                .row = euroc::row,
                .whole_times = WholeTimes{.per_second = euroc::nanoseconds, .unit = "nanosecond"}}};

}}}  // namespace orispline::io
