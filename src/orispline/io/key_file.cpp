// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_file.hpp>

#include <utility>

#include <fmt/format.h>

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

Expected<Layout> tum_layout(const TextTable& table, const ReadOptions& options) {
  if (options.order) return contradiction(table, "--order is for CSV, and TUM is always t tx ty tz qx qy qz qw");
  if (!options.columns.empty()) return contradiction(table, "--columns needs a header, and TUM has none");
  return Layout{FileFormat::tum, columns_of_tum(), Layout::FirstRow::key};
}

Expected<Layout> header_layout(const TextTable& table, const ReadOptions& options) {
  if (options.order) return contradiction(table, "--order is for CSV without a header, and this line is one");
  auto columns =
      columns_of_header(table.cells(), {.names = options.columns,
                                        .parameters = options.parameters,
                                        .rate_frame = options.conjugate ? RateFrame::unknown : RateFrame::body});
  return columns
      .map([](KeyColumns& found) {
        return Layout{FileFormat::csv, std::move(found), Layout::FirstRow::header};
      })
      .map_error([&table](Error error) {
        error.where = table.here();
        return error;
      });
}

Expected<Layout> order_layout(const TextTable& table, const ReadOptions& options) {
  if (!options.columns.empty()) return contradiction(table, "--columns needs a header, and the file has none");
  if (!options.order)
    return failure(ErrorCode::bad_data,
                   fmt::format("no header, wanted a first line such as t,qw,qx,qy,qz or the order of the columns by "
                               "--order wxyz|xyzw{}",
                               has_tum_shape(table) ? " (or --input-format tum)" : ""),
                   table.here());
  return columns_of_order(width_of(table.cells()), *options.order)
      .map([](const KeyColumns& columns) {
        return Layout{FileFormat::csv, columns, Layout::FirstRow::key};
      })
      .map_error([&table](Error error) {
        error.where = table.here();
        return error;
      });
}

/// Decides by the options, the extension and the first row of the table.
Expected<Layout> layout_of(const TextTable& table, const ReadOptions& options, std::optional<FileFormat> format) {
  if (format == FileFormat::tum) return tum_layout(table, options);
  if (is_header(table.cells())) return header_layout(table, options);
  if (!format && !options.order && has_tum_shape(table)) return tum_layout(table, options);
  return order_layout(table, options);
}

}  // namespace

Expected<KeyFile> read_keys(const std::string& path, const ReadOptions& options) {
  if (options.time_scale && *options.time_scale <= Decimal())
    return failure(ErrorCode::bad_argument, fmt::format("the time scale is {}, wanted a number greater than 0",
                                                        options.time_scale->to_string()));
  auto table = TextTable::open(path);
  if (!table) return tl::unexpected(std::move(table.error()));
  const std::optional<FileFormat> format = options.format ? options.format : format_of_extension(path);
  if (format == FileFormat::tum) table->set_delimiter(Delimiter::blanks);
  const auto first = table->next();
  if (!first) return tl::unexpected(first.error());
  if (!*first) return failure(ErrorCode::bad_data, "empty: no keys", {.file = path});
  auto layout = layout_of(*table, options, format);
  if (!layout) return tl::unexpected(std::move(layout.error()));
  if (options.time_scale) layout->columns.time_unit = *options.time_scale;

  KeyRows rows(path, layout->format, std::move(layout->columns), options);
  auto more = layout->first_row == Layout::FirstRow::header ? table->next() : first;
  for (; more && *more; more = table->next())
    if (auto added = rows.add(*table); !added) return tl::unexpected(std::move(added.error()));
  if (!more) return tl::unexpected(more.error());
  return std::move(rows).finish();
}

Error located(const KeyFile& file, Error error) {
  error.where.file = file.path;
  if (error.where.key && *error.where.key < file.lines.size()) error.where.line = file.lines[*error.where.key];
  return error;
}

}  // namespace orispline::io
