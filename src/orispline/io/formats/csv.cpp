// SPDX-License-Identifier: Apache-2.0
// Tables with named columns, or with a stated order of them.
#include <algorithm>
#include <optional>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/format_choice.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/key_table.hpp>
#include <orispline/io/sample_columns.hpp>
#include <orispline/io/text_row.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace { namespace csv {

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array<std::string_view, 8> names_wxyz{"t", "qw", "qx", "qy", "qz", "px", "py", "pz"},
    names_xyzw{"t", "qx", "qy", "qz", "qw", "px", "py", "pz"};

RateReading rate_reading(const ReadOptions& options) {
  return {.orders = options.rate_orders, .world = options.world_rates};
}

using Cells = std::span<const std::string_view>;

Expected<TableLayout> layout_of_names(const TextTable& table, Cells header, const ReadOptions& options) {
  const HeaderReading reading{.names = options.columns,
                              .parameters = options.parameters,
                              .rates = rate_reading(options),
                              .inner_quaternions = options.inner_quaternions,
                              .orientation = options.orientation,
                              .count_rows = options.count_rows,
                              .positions = !options.no_positions};
  return located(table, columns_of_header(header, reading)).map([&](KeyColumns columns) {
    std::vector<std::string> names(header.begin(), header.end());
    names.resize(columns.width);
    return TableLayout{std::move(columns), std::move(names), TableLayout::FirstRow::header};
  });
}

Expected<TableLayout> layout_of_header(const TextTable& table, const ReadOptions& options) {
  if (options.order)
    return misplaced(table, "order", "found a header, which states the order of the columns, wanted CSV without one");
  return layout_of_names(table, table.cells(), options);
}

/// By a comment that names the columns; nothing where it is other text.
std::optional<Expected<TableLayout>> layout_of_comment(const TextTable& table, const ReadOptions& options) {
  const std::vector<std::string_view> cells = table.header_in_comment();
  if (cells.empty()) return std::nullopt;
  auto found = layout_of_names(table, cells, options);
  if (!found && (found.error().remedy.empty() || found.error().remedy == "columns")) return std::nullopt;
  if (!found) return found;
  found->first_row = TableLayout::FirstRow::key;
  found->columns.commented_header = table.comment();
  return found;
}

/// No header and no order: another format may be meant.
tl::unexpected<Error> no_header(const TextTable& table, const ReadOptions& options) {
  const std::string_view example = "t,qw,qx,qy,qz";
  const FormatInfo* const like = likest(formats_read(), table, options, Likeness::possible);
  const std::string other = like ? formatted(", the format {}, of which this line may be,", like->id) : "";
  return mended_by("order",
                   formatted("no header, wanted a first line such as {}{} or the order of the columns", example, other),
                   table.here());
}

Expected<TableLayout> layout_of_order(const TextTable& table, const ReadOptions& options) {
  if (!options.order)
    if (auto found = layout_of_comment(table, options)) return std::move(*found);
  if (const auto option = header_option(options))
    return misplaced(table, *option, "found no header, wanted one that names the columns");
  if (!options.order) return no_header(table, options);
  const std::size_t width = width_of(table.cells());
  return located(table, columns_of_order(width, options)).map([&](KeyColumns columns) {
    const std::ptrdiff_t first = width == 4 || width == 7 ? 1 : 0;  // without a time
    const auto& names = *options.order == QuaternionOrder::xyzw ? names_xyzw : names_wxyz;
    return TableLayout{std::move(columns),
                       {names.begin() + first, names.begin() + first + static_cast<std::ptrdiff_t>(width)},
                       TableLayout::FirstRow::key};
  });
}

Expected<TableLayout> layout(const TextTable& table, const ReadOptions& options) {
  return is_header(table.cells()) ? layout_of_header(table, options) : layout_of_order(table, options);
}

std::string header(const SampleColumns& columns, std::size_t) {
  return formatted("{}\n", joined(column_names(columns), ","));
}

void row(std::string& bytes, const Decimal& time, std::span<const double> numbers) {
  append_text_row(bytes, time, numbers, ',');
}

}  // namespace csv

}  // namespace

constinit const FormatInfo csv_format{
    .id = "csv",
    .title = "CSV",
    .file = "a CSV file",
    .summary = "named columns, separated by commas, semicolons, tabs or blanks",
    .extensions = csv::extensions,
    .holds = {.forms = true, .rates = true, .settings = true, .comments = true},
    .reading = {.layout = csv::layout},
    .writing = {.header = csv::header, .numbers = named_numbers, .row = csv::row, .table = csv_with_columns}};

}}}  // namespace orispline::io
