// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/times_file.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/iso_time.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/text_table.hpp>
#include <orispline/io/time_column.hpp>

namespace orispline::inline ORISPLINE_ABI::io {
namespace {

tl::unexpected<Error> at_row(const TextTable& table, std::string message) {
  return failure(ErrorCode::bad_data, std::move(message), table.here());
}

/// The only cell of the row; empty ones may follow.
Expected<std::string_view> only_cell(const TextTable& table) {
  std::size_t count = table.cells().size();
  while (count > 1 && table.cells()[count - 1].empty()) --count;
  if (count > 1) return at_row(table, formatted("found {} cells, wanted one time a line", count));
  return table.cells()[0];
}

/// How the times of a file are counted.
struct RowUnit {
  Fraction seconds{};
  bool is_stated = false;
};

/// That of the times below the header.
Expected<RowUnit> unit_of_header(const TextTable& table, const Clock& clock) {
  return only_cell(table).and_then([&](std::string_view name) -> Expected<RowUnit> {
    const ColumnSearch search(std::span(&name, 1), {});
    if (const auto unit = time_unit_of(search.plain_name(0))) return RowUnit{unit->seconds, unit->is_stated};
    if (counts_frames(search.plain_name(0)))
      return seconds_per_frame(name, clock)
          .map([](const Fraction& seconds) {
            return RowUnit{seconds, true};
          })
          .map_error([&](Error error) { return error.where = table.here(), error; });
    return at_row(table, formatted("found {}, wanted the header t or a number", in_quotes(name)));
  });
}

/// The time in the row [s].
Expected<Decimal> time_of(const TextTable& table, RowUnit& unit, const Clock& clock) {
  return only_cell(table).and_then([&](std::string_view cell) -> Expected<Decimal> {
    if (looks_like_iso_time(cell))
      return parse_iso_time(cell)
          .map([&](const Decimal& time) { return time - clock.zero; })
          .map_error([&](Error error) { return error.where = table.here(), error; });
    const auto time = decimal_of(cell);
    if (!time) return at_row(table, time.error().message);
    if (!*time) return at_row(table, formatted("found {}, wanted a finite time", in_quotes(cell)));
    if (!std::exchange(unit.is_stated, true))
      if (const auto guess = time_unit_by_size(**time)) unit.seconds = guess->seconds;
    return unit.seconds.time_of(**time);
  });
}

}  // namespace

Expected<TimesList> read_times(const std::string& path, const Decimal& epoch, const Clock& clock) {
  auto table = TextTable::open(path);
  if (!table) return tl::unexpected(std::move(table.error()));
  RowUnit unit;
  auto more = table->next();
  if (more && *more && is_header(table->cells())) {
    const auto header_unit = unit_of_header(*table, clock);
    if (!header_unit) return tl::unexpected(header_unit.error());
    unit = *header_unit;
    more = table->next();
  }
  TimesList list;
  for (; more && *more; more = table->next()) {
    const auto time = time_of(*table, unit, clock);
    if (!time) return tl::unexpected(time.error());
    list.times.push_back((*time - epoch).to_double());
    list.lines.push_back(static_cast<std::uint32_t>(table->line()));
  }
  if (!more) return tl::unexpected(more.error());
  if (list.times.empty()) return failure(ErrorCode::bad_data, "empty: no times", {.file = path});
  return list;
}

}  // namespace orispline::inline ORISPLINE_ABI::io
