// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/times_file.hpp>

#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/clock.hpp>
#include <orispline/io/format_choice.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/text_table.hpp>
#include <orispline/io/time_cells.hpp>
#include <orispline/io/time_column.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

tl::unexpected<Error> at_row(const TextTable& table, std::string message) {
  return failure(ErrorCode::bad_data, std::move(message), table.here());
}

Error located(const TextTable& table, Error error) {
  error.where = table.here();
  return error;
}

}  // namespace

Expected<TimeColumn> time_column(const TextTable& table, std::span<const std::string_view> header,
                                 const ReadOptions& options) {
  const ColumnNames none;
  const auto mapped = options.columns.find(time_name);
  if (const auto two = two_time_columns(ColumnSearch(header, none), options.columns); two && *two)
    return TimeColumn{(*two)->index, (*two)->unit, true, (*two)->rest};
  const bool is_there = mapped != options.columns.end() && std::ranges::find(header, mapped->second) != header.end();
  const ColumnSearch search(header, is_there ? options.columns : none);
  auto found = search.column(time_name, [](std::string_view name) { return time_unit_of(name).has_value(); });
  if (found && !*found) found = search.column(time_name, counts_frames);
  if (!found) return tl::unexpected(located(table, found.error()));
  if (!*found)
    return at_row(table, formatted("found {}, wanted a column of times such as t, or numbers without a header",
                                   search.found_names()));
  const std::string_view name = search.plain_name(**found);
  if (counts_frames(name)) {
    const auto seconds = seconds_per_frame(search.name(**found), options.clock);
    if (!seconds) return tl::unexpected(located(table, seconds.error()));
    return TimeColumn{**found, *seconds, true};
  }
  const TimeUnit unit = time_unit_of(name).value_or(time_unit_at_end_of(name));
  return TimeColumn{**found, unit.seconds, unit.is_stated};
}

Expected<Decimal> time_of(const TextTable& table, TimeColumn& column, const Clock& clock,
                          std::vector<Warning>& warnings) {
  if (column.index >= table.cells().size())
    return at_row(table, formatted("found {}, wanted the time in cell {}", counted(table.cells().size(), "cell"),
                                   column.index + 1));
  const std::string_view cell = table.cells()[column.index];
  const auto refused = [&](std::string message) {
    return failure(ErrorCode::bad_data, std::move(message), table.here(column.index));
  };
  if (looks_like_iso_time(cell)) {
    const auto time = parse_iso_time(cell);
    return time ? Expected<Decimal>(*time - clock.zero) : refused(time.error().message);
  }
  const auto time = decimal_of(cell);
  if (!time) return refused(time.error().message);
  if (!*time) return refused(formatted("found {}, wanted a finite time", in_quotes(cell)));
  if (!std::exchange(column.states_unit, true))
    if (auto guess = time_unit_by_size(**time)) {
      column.unit = guess->seconds;
      guess->warning.where.file = table.path();
      warnings.push_back(std::move(guess->warning));
    }
  if (!column.rest) return column.unit.time_of(**time);
  const auto rest = column.rest->index < table.cells().size() ? decimal_of(table.cells()[column.rest->index])
                                                              : Expected<std::optional<Decimal>>(std::nullopt);
  if (!rest || !*rest) return at_row(table, "found no finite number in the second column of the time, wanted one");
  return column.unit.time_of(**time + column.rest->unit.of(**rest));
}

namespace {

/// Of the table at its first row; a comment that names it is warned of.
Expected<TimeColumn> column_of_times(const TextTable& table, const ReadOptions& options,
                                     std::vector<Warning>& warnings) {
  const std::size_t width = width_of(table.cells());
  const auto formats = formats_read();
  const FormatInfo* const format = width > 1 ? likest(formats, table, options, Likeness::likely) : nullptr;
  if (format && format->reading.layout && !is_header(table.cells()))
    return format->reading.layout(table, options).map([](const TableLayout& layout) {
      return TimeColumn{layout.columns.time, layout.columns.time_unit, layout.columns.states_time_unit};
    });
  const std::vector<std::string_view> header = header_of(table);
  if (is_header(table.cells())) return time_column(table, header, options);
  if (!header.empty() && !options.order)
    if (auto named = time_column(table, header, options)) {
      warnings.push_back(commented_header(table.comment(), table.path()));
      return named;
    }
  if (width > 1 && !options.order)
    return at_row(table,
                  formatted("found {} cells, wanted one time a line, or a header that names the column t", width));
  return TimeColumn{};
}

}  // namespace

Expected<TimesList> read_times(const Input& input, const Decimal& epoch, const ReadOptions& options) {
  auto table = TextTable::open(input);
  if (!table) return tl::unexpected(std::move(table.error()));
  auto more = table->next();
  if (!more) return tl::unexpected(more.error());
  if (!*more) return failure(ErrorCode::bad_data, "empty: no times", {.file = input.name()});
  TimesList list;
  auto column = column_of_times(*table, options, list.warnings);
  if (!column) return tl::unexpected(column.error());
  if (is_header(table->cells())) more = table->next();
  for (; more && *more; more = table->next()) {
    const auto time = time_of(*table, *column, options.clock, list.warnings);
    if (!time) return tl::unexpected(time.error());
    list.times.push_back((*time - epoch).to_double());
    list.lines.push_back(static_cast<std::uint32_t>(table->line()));
  }
  if (!more) return tl::unexpected(more.error());
  if (list.times.empty()) return failure(ErrorCode::bad_data, "empty: no times", {.file = input.name()});
  return list;
}

}}}  // namespace orispline::io
