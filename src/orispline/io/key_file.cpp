// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_file.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/euroc.hpp>
#include <orispline/io/key_rows.hpp>

namespace orispline::io {
namespace {

/// How the rows of a table are to be read.
struct Layout {
  FileFormat format;
  KeyColumns columns;
  enum class FirstRow { header, key } first_row;
};

tl::unexpected<Error> contradiction(const TextTable& table, std::string message) {
  return failure(ErrorCode::bad_argument, std::move(message), table.here());
}

std::size_t width_of(std::span<const std::string_view> cells) {
  while (!cells.empty() && cells.back().empty()) cells = cells.first(cells.size() - 1);
  return cells.size();
}

bool has_tum_shape(const TextTable& table) {
  return table.delimiter() != Delimiter::comma && table.delimiter() != Delimiter::semicolon &&
         width_of(table.cells()) == 8;
}

/// Times of this many digits are nanoseconds of the Unix epoch.
bool has_euroc_shape(const TextTable& table) {
  constexpr std::size_t digits_of_nanoseconds = 18;
  return width_of(table.cells()) >= euroc_columns && table.cells()[0].size() > digits_of_nanoseconds &&
         table.cells()[0].find_first_not_of("0123456789") == std::string_view::npos;
}

/// The option that asks for something that only a header can give, if any.
std::optional<std::string_view> header_option(const ReadOptions& options) {
  if (!options.columns.empty()) return "--columns";
  if (options.orientation.representation) return "--input-orientation";
  if (options.orientation.euler) return "--euler";
  if (options.orientation.angle_unit) return "--angle-unit";
  return std::nullopt;
}

Expected<Layout> at(const TextTable& table, Expected<KeyColumns> columns, FileFormat format, Layout::FirstRow first) {
  if (columns) return Layout{format, std::move(*columns), first};
  columns.error().where = table.here();
  return tl::unexpected(std::move(columns.error()));
}

Expected<Layout> tum_layout(const TextTable& table, const ReadOptions& options) {
  if (options.order) return contradiction(table, "--order is for CSV, and TUM is always t tx ty tz qx qy qz qw");
  if (const auto option = header_option(options))
    return contradiction(table, formatted("{} needs a header, and TUM has none", *option));
  return Layout{FileFormat::tum, columns_of_tum(), Layout::FirstRow::key};
}

Expected<Layout> euroc_layout(const TextTable& table, const ReadOptions& options) {
  if (options.order)
    return contradiction(table, "--order is for CSV, and EuRoC is always time, position, quaternion w,x,y,z");
  if (const auto option = header_option(options))
    return contradiction(table, formatted("{} is for CSV, and the columns of EuRoC are fixed", *option));
  return at(table, columns_of_euroc(width_of(table.cells())), FileFormat::euroc,
            is_header(table.cells()) ? Layout::FirstRow::header : Layout::FirstRow::key);
}

RateReading rate_reading(const ReadOptions& options) {
  return {.orders = options.rate_orders,
          .world = options.world_rates,
          .unnamed = options.conjugate ? UnnamedRates::unknown : UnnamedRates::body};
}

Expected<Layout> header_layout(const TextTable& table, const ReadOptions& options) {
  if (options.order) return contradiction(table, "--order is for CSV without a header, and this line is one");
  const HeaderReading reading{.names = options.columns,
                              .parameters = options.parameters,
                              .rates = rate_reading(options),
                              .orientation = options.orientation};
  return at(table, columns_of_header(table.cells(), reading), FileFormat::csv, Layout::FirstRow::header);
}

Expected<Layout> order_layout(const TextTable& table, const ReadOptions& options) {
  if (const auto option = header_option(options))
    return contradiction(table, formatted("{} needs a header, and the file has none", *option));
  const std::string_view other_format = has_tum_shape(table)     ? " (or --input-format tum)"
                                        : has_euroc_shape(table) ? " (or --input-format euroc)"
                                                                 : "";
  if (!options.order)
    return failure(ErrorCode::bad_data,
                   formatted("no header, wanted a first line such as t,qw,qx,qy,qz or the order of the columns by "
                             "--order wxyz|xyzw{}",
                             other_format),
                   table.here());
  return at(table, columns_of_order(width_of(table.cells()), *options.order), FileFormat::csv, Layout::FirstRow::key);
}

/// Whether a header says so, and the caller does not read it otherwise.
bool is_named_euroc(const TextTable& table, const ReadOptions& options) {
  return !options.format && options.columns.empty() && (names_euroc(table.comment()) || names_euroc(table.cells()));
}

/// Decides by the options, the extension and the first row of the table.
Expected<Layout> layout_of(const TextTable& table, const ReadOptions& options, std::optional<FileFormat> format) {
  if (format == FileFormat::tum) return tum_layout(table, options);
  if (format == FileFormat::euroc || is_named_euroc(table, options)) return euroc_layout(table, options);
  if (is_header(table.cells())) return header_layout(table, options);
  if (!format && !options.order && has_tum_shape(table)) return tum_layout(table, options);
  return order_layout(table, options);
}

/// The names of the columns: those of the header, else such as `read_keys` would understand in one.
std::vector<std::string> names_of(const TextTable& table, const Layout& layout, const ReadOptions& options) {
  std::vector<std::string> names;
  if (layout.format == FileFormat::tum) names = {"t", "px", "py", "pz", "qx", "qy", "qz", "qw"};
  else if (layout.format == FileFormat::euroc) names = {"t_ns", "px", "py", "pz", "qw", "qx", "qy", "qz"};
  else if (layout.first_row == Layout::FirstRow::header) return {table.cells().begin(), table.cells().end()};
  else if (options.order == QuaternionOrder::xyzw) names = {"t", "qx", "qy", "qz", "qw", "px", "py", "pz"};
  else names = {"t", "qw", "qx", "qy", "qz", "px", "py", "pz"};
  for (std::size_t i = names.size(); i < layout.columns.width; ++i) names.push_back(formatted("column{}", i + 1));
  names.resize(layout.columns.width);
  return names;
}

}  // namespace

Expected<KeyFile> read_keys(const std::string& path, const ReadOptions& options) {
  if (options.time_scale && *options.time_scale <= Decimal())
    return failure(ErrorCode::bad_argument,
                   formatted("the time scale is {}, wanted a number greater than 0", options.time_scale->to_string()));
  const std::optional<FileFormat> format = options.format ? options.format : format_of_extension(path);
  if (format == FileFormat::npy)
    return failure(ErrorCode::bad_argument, "keys are not read from NumPy files, wanted CSV, TUM or EuRoC",
                   {.file = path});
  auto table = TextTable::open(path);
  if (!table) return tl::unexpected(std::move(table.error()));
  if (format == FileFormat::tum) table->set_delimiter(Delimiter::blanks);
  if (format == FileFormat::euroc) table->set_delimiter(Delimiter::comma);
  const auto first = table->next();
  if (!first) return tl::unexpected(first.error());
  if (!*first) return failure(ErrorCode::bad_data, "empty: no keys", {.file = path});
  auto layout = layout_of(*table, options, format);
  if (!layout) return tl::unexpected(std::move(layout.error()));
  if (options.time_scale) {
    layout->columns.time_unit = *options.time_scale;
    layout->columns.whole_times = false;
  }

  std::vector<std::string> names = names_of(*table, *layout, options);
  KeyRows rows(path, layout->format, std::move(layout->columns), options);
  auto more = layout->first_row == Layout::FirstRow::header ? table->next() : first;
  for (; more && *more; more = table->next())
    if (auto added = rows.add(*table); !added) return tl::unexpected(std::move(added.error()));
  if (!more) return tl::unexpected(more.error());
  return std::move(rows).finish().map([&](KeyFile&& file) {
    if (options.keep_table) file.table.names = std::move(names);
    return std::move(file);
  });
}

Error located(const KeyFile& file, Error error) {
  error.where.file = file.path;
  if (error.where.key && *error.where.key < file.lines.size()) error.where.line = file.lines[*error.where.key];
  return error;
}

}  // namespace orispline::io
