// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/rates_file.hpp>

#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/rates_order.hpp>
#include <orispline/io/round_clock.hpp>
#include <orispline/io/text_row.hpp>
#include <orispline/io/text_table.hpp>
#include <orispline/io/time_cells.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

/// Which cells of a row are the rate and the time.
struct GyroColumns {
  VectorColumns rate;
  TimeColumn time;
};

/// The columns of the rates that the header names.
Expected<VectorColumns> rate_columns_of(const TextTable& table, std::span<const std::string_view> header,
                                        const ReadOptions& options) {
  const ColumnSearch search(header, options.columns);
  auto found = rate_columns(search, {.orders = 1, .world = false});
  if (!found) {
    found.error().where = table.here();
    return tl::unexpected(std::move(found.error()));
  }
  if (!(*found)[0])
    return failure(ErrorCode::bad_data,
                   formatted("found {}, wanted the rates of the body wx, wy and wz", search.found_names()),
                   table.here());
  return (*found)[0]->columns;
}

Expected<GyroColumns> columns_of(const TextTable& table, const ReadOptions& options) {
  const std::vector<std::string_view> header = header_of(table);
  if (header.empty())
    return failure(ErrorCode::bad_data, "found no header, wanted one that names t, wx, wy and wz", table.here());
  return rate_columns_of(table, header, options).and_then([&](const VectorColumns& rate) {
    return time_column(table, header, options).map([&](const TimeColumn& time) { return GyroColumns{rate, time}; });
  });
}

/// Not finite where a cell is empty or not a finite number.
Expected<Eigen::Vector3d> rate_of(const TextTable& table, const VectorColumns& columns) {
  Eigen::Vector3d rate;
  for (std::size_t axis = 0; axis < columns.size(); ++axis) {
    const NumberColumn& column = columns[axis];
    if (column.index >= table.cells().size())
      return failure(ErrorCode::bad_data,
                     formatted("found {} cells, wanted the rate in cell {}", table.cells().size(), column.index + 1),
                     table.here());
    const auto number = number_of(table.cells()[column.index]);
    if (!number) return failure(ErrorCode::bad_data, number.error().message, table.here(column.index));
    rate[static_cast<Eigen::Index>(axis)] = *number * column.numerator / column.denominator;
  }
  return rate;
}

}  // namespace

Expected<RateRows> read_rates(Input file, const ReadOptions& options) {
  ReadOptions no_keys = options;
  no_keys.recipe = RecipeUse::ignored;
  return KeyInput::open(std::move(file), no_keys).and_then([&](KeyInput input) {
    return read_rates(std::move(input), options);
  });
}

Expected<RateRows> read_rates(KeyInput input, const ReadOptions& options) {
  if (auto checked = check_frames(options); !checked) return tl::unexpected(std::move(checked.error()));
  const std::string path = input.path();
  TextTable table(std::move(input).lines());
  auto more = table.next();
  if (!more) return tl::unexpected(std::move(more.error()));
  if (!*more) return failure(ErrorCode::bad_data, "empty: no rates", {.file = path});
  auto columns = columns_of(table, options);
  if (!columns) return tl::unexpected(std::move(columns.error()));
  RateRows rows;
  TimeColumn& time = columns->time;
  const NewFrames frames(options.frames);
  std::optional<RoundClock> clock;
  if (is_header(table.cells())) more = table.next();
  else rows.warnings.push_back(commented_header(table.comment(), path));
  for (; more && *more; more = table.next()) {
    const auto rate = rate_of(table, columns->rate);
    if (!rate) return tl::unexpected(rate.error());
    if (!rate->allFinite()) continue;
    auto t = time_of(table, time, options.clock, rows.warnings);
    if (const auto& round = options.clock.round; round && !clock)
      clock.emplace(round->is_in_seconds ? round->length : time.unit.time_of(round->length));
    if (!t) return tl::unexpected(std::move(t.error()));
    if (clock) t = clock->counted_on(*t);
    if (!t) return failure(t.error().code, std::move(t.error().message), table.here(time.index));
    rows.exact_times.push_back(*t);
    rows.rates.push_back(frames.body_rate(*rate));
    rows.lines.push_back(static_cast<std::uint32_t>(table.line()));
  }
  if (!more) return tl::unexpected(std::move(more.error()));
  if (rows.rates.empty()) return failure(ErrorCode::bad_data, "empty: no rates", {.file = path});
  return choose_session(rows, options, path).and_then([&] { return put_in_order(rows, options, path); }).map([&] {
    return std::move(rows);
  });
}

bool holds_rates_alone(KeyInput& input, const ReadOptions& options) {
  const std::vector<std::string> names = input.header();
  const std::vector<std::string_view> header(names.begin(), names.end());
  const ColumnSearch search(header, options.columns);
  const auto orientation = orientation_columns(search, {});
  const auto rates = rate_columns(search, {.orders = 1, .world = false});
  return orientation && orientation->group.is_absent() && rates && (*rates)[0];
}

Expected<void> write_rates(OutputFile& file, const RateRows& rows) {
  if (auto written = file.write("t,wx,wy,wz\n"); !written) return written;
  std::string line;
  for (std::size_t k = 0; k < rows.rates.size(); ++k) {
    line.clear();
    append_text_row(line, rows.exact_times[k], {rows.rates[k].data(), 3}, ',');
    if (auto written = file.write(line); !written) return written;
  }
  return {};
}

}}}  // namespace orispline::io
