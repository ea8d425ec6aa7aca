// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/times_file.hpp>

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/text_table.hpp>

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

/// Unit [s] of the times below the header.
Expected<Decimal> unit_of_header(const TextTable& table) {
  return only_cell(table).and_then([&table](std::string_view name) -> Expected<Decimal> {
    if (const auto unit = time_unit_of(name)) return unit->seconds;
    return at_row(table, formatted("found {}, wanted the header t or a number", in_quotes(name)));
  });
}

/// The time [s] in the row.
Expected<Decimal> time_of(const TextTable& table, const Decimal& unit) {
  return only_cell(table).and_then([&](std::string_view cell) -> Expected<Decimal> {
    const auto time = decimal_of(cell);
    if (!time) return at_row(table, time.error().message);
    if (!*time) return at_row(table, formatted("found {}, wanted a finite time", in_quotes(cell)));
    return **time * unit;
  });
}

}  // namespace

Expected<TimesList> read_times(const std::string& path, const Decimal& epoch) {
  auto table = TextTable::open(path);
  if (!table) return tl::unexpected(std::move(table.error()));
  Decimal unit = Decimal::power_of_ten(0);
  auto more = table->next();
  if (more && *more && is_header(table->cells())) {
    const auto header_unit = unit_of_header(*table);
    if (!header_unit) return tl::unexpected(header_unit.error());
    unit = *header_unit;
    more = table->next();
  }
  TimesList list;
  for (; more && *more; more = table->next()) {
    const auto time = time_of(*table, unit);
    if (!time) return tl::unexpected(time.error());
    list.times.push_back((*time - epoch).to_double());
    list.lines.push_back(static_cast<std::uint32_t>(table->line()));
  }
  if (!more) return tl::unexpected(more.error());
  if (list.times.empty()) return failure(ErrorCode::bad_data, "empty: no times", {.file = path});
  return list;
}

}  // namespace orispline::inline ORISPLINE_ABI::io
