// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/rates_order.hpp>

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <orispline/curve/key_parts.hpp>
#include <orispline/io/order_errors.hpp>
#include <orispline/io/time_order.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

using Places = std::vector<std::uint32_t>;

Places places_from(std::size_t first, std::size_t end) {
  Places places(end - first);
  std::iota(places.begin(), places.end(), static_cast<std::uint32_t>(first));
  return places;
}

/// Of the row `later`, whose time does not rise, with the remedy for all that follow.
tl::unexpected<Error> out_of_order(const RateRows& rows, std::size_t later, const std::string& path) {
  const Decimal &before = rows.exact_times[later - 1], &time = rows.exact_times[later];
  const Where where{.file = path, .line = rows.lines[later]};
  const std::string text = time.to_string();
  if (time == before) return mended_by("drop_duplicates", duplicate_time(text, rows.lines[later - 1]), where);
  const bool begins = session_starts(std::span(rows.exact_times).subspan(later - 1)).size() > 1;
  return falling_time(text, before, begins, where);
}

}  // namespace

RateRows rows_at(const RateRows& rows, const std::vector<std::uint32_t>& places) {
  return {.exact_times = entries_at(rows.exact_times, places),
          .rates = entries_at(rows.rates, places),
          .lines = entries_at(rows.lines, places),
          .warnings = rows.warnings};
}

Expected<void> choose_session(RateRows& rows, const ReadOptions& options, const std::string& path) {
  std::vector<std::size_t> starts = session_starts(rows.exact_times);
  if (starts.size() == 1) return {};
  if (!options.session) {
    if (!options.sort || may_be_sorted(rows.exact_times.size(), starts.size())) return {};
    return mixed_sessions(starts.size(), {.file = path, .line = rows.lines[starts[1]]});
  }
  const std::size_t session = *options.session;
  if (session > starts.size() || session == all_sessions) return no_such_session(session, starts.size());
  starts.push_back(rows.exact_times.size());
  rows = rows_at(rows, places_from(starts[session - 1], starts[session]));
  return {};
}

Expected<void> put_in_order(RateRows& rows, const ReadOptions& options, const std::string& path) {
  const auto& times = rows.exact_times;
  Places places = places_from(0, times.size());
  if (options.sort) std::ranges::stable_sort(places, {}, [&](std::uint32_t place) { return times[place]; });
  if (options.drop_duplicates) {
    const auto same = [&](std::uint32_t one, std::uint32_t other) { return times[one] == times[other]; };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());  // Clang 14 cannot take ranges::unique
  }
  if (options.sort || options.drop_duplicates) rows = rows_at(rows, places);
  const auto unrising = std::ranges::adjacent_find(times, std::ranges::greater_equal());
  if (unrising == times.end()) return {};
  return out_of_order(rows, static_cast<std::size_t>(unrising - times.begin()) + 1, path);
}

}}}  // namespace orispline::io
