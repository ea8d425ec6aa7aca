// SPDX-License-Identifier: Apache-2.0
#include "options/sample_times.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <orispline/io/times_file.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {
namespace {

/// A sample this near to the end, in sample intervals and relative to their number, is the one at the end.
constexpr double end_tolerance = 1e-9, relative_end_tolerance = 4e-16;
/// More samples than that cannot be told apart by a double.
constexpr double most_samples = 9e15;

using Spacing = std::variant<Rate, Count, TimesFile>;

Expected<Spacing> spacing_in(const TimeOptions& options) {
  const int given = options.rate.has_value() + options.count.has_value() + options.list.has_value();
  if (given != 1)
    return usage_failure(fmt::format("found {} of --rate, --count and --times, wanted one of them",
                                     given == 0 ? "none" : std::to_string(given)));
  if (options.list) return Spacing(TimesFile{*options.list});
  if (options.count)
    return count_in({"--count", *options.count}, 1).map([](std::size_t n) { return Spacing(Count{n}); });
  const OptionText rate{"--rate", *options.rate};
  const auto hertz = number_in(rate);
  if (!hertz || *hertz <= 0.0) return wanted(rate, "a number of samples per second greater than 0");
  return Spacing(Rate{*hertz});
}

}  // namespace

Expected<TimeRequest> time_request(const TimeOptions& options) {
  FirstError checked;
  TimeRequest request{.spacing = checked(spacing_in(options)),
                      .from = checked(if_given("--from", options.from, decimal_in)),
                      .to = checked(if_given("--to", options.to, decimal_in))};
  auto read = std::move(checked).or_else(std::move(request));
  if (read && options.list && (options.from || options.to))
    return usage_failure("--times: the file says which times, wanted neither --from nor --to");
  if (read && read->from && read->to && *read->from > *read->to)
    return usage_failure(fmt::format("--from {} is after --to {}", *options.from, *options.to));
  return read;
}

Expected<SampleTimes> SampleTimes::make(const TimeRequest& request, const Decimal& key_epoch, const Domain& domain) {
  const auto* const file = std::get_if<TimesFile>(&request.spacing);
  if (!file) return grid(request, key_epoch, domain);
  return io::read_times(file->path, key_epoch).map([&](io::TimesList list) {
    const std::size_t size = list.times.size();
    return SampleTimes(key_epoch, key_epoch, size, List{file->path, std::move(list)});
  });
}

Expected<SampleTimes> SampleTimes::grid(const TimeRequest& request, const Decimal& key_epoch, const Domain& domain) {
  const Decimal first = Decimal::from_double(domain.start), last = Decimal::from_double(domain.end);
  const Decimal start = request.from ? *request.from - key_epoch : first;
  const Decimal end = request.to ? *request.to - key_epoch : last;
  if (start > end && request.from)
    return usage_failure(fmt::format("--from {} is after the end at {}, wanted --to as well", request.from->to_string(),
                                     (key_epoch + last).to_string()));
  if (start > end)
    return usage_failure(fmt::format("--to {} is before the start at {}, wanted --from as well",
                                     request.to->to_string(), (key_epoch + first).to_string()));
  const Decimal epoch = key_epoch + start;
  Grid grid{
      .spacing = Count{1}, .start = io::TimeOrigin(start), .end = end.to_double(), .span = (end - start).to_double()};
  if (const auto* const count = std::get_if<Count>(&request.spacing)) {
    if (count->samples > 1 && grid.span == 0.0)
      return usage_failure(fmt::format("--count {}: the range is the single time {}, wanted --count 1", count->samples,
                                       epoch.to_string()));
    grid.spacing = *count;
    grid.index_of_end = count->samples - 1;
    return SampleTimes(key_epoch, epoch, count->samples, grid);
  }
  const Rate rate = std::get<Rate>(request.spacing);
  const double exact = grid.span * rate.hertz, nearest = std::round(exact);
  const bool meets_end = std::abs(exact - nearest) <= end_tolerance + relative_end_tolerance * exact;
  const double intervals = meets_end ? nearest : std::floor(exact);
  if (!(intervals < most_samples))
    return usage_failure(fmt::format("--rate {} makes {:.3g} samples over {} s, wanted fewer than {:.0e}", rate.hertz,
                                     intervals, grid.span, most_samples));
  grid.spacing = rate;
  if (meets_end) grid.index_of_end = static_cast<std::size_t>(intervals);
  return SampleTimes(key_epoch, epoch, static_cast<std::size_t>(intervals) + 1, grid);
}

double SampleTimes::Grid::offset(std::size_t k, std::size_t size) const {
  if (k == 0) return 0.0;
  if (k == index_of_end) return span;
  const auto steps = static_cast<double>(k);
  if (const auto* const rate = std::get_if<Rate>(&spacing)) return steps / rate->hertz;
  return span * steps / static_cast<double>(size - 1);
}

Instant SampleTimes::operator[](std::size_t k) const {
  if (const auto* const list = std::get_if<List>(&times_)) return {list->list.times[k], list->list.times[k]};
  const Grid& grid = std::get<Grid>(times_);
  const double offset = grid.offset(k, size_);
  if (offset == grid.span) return {grid.end, offset};
  return {grid.start.nearest_plus(offset), offset};
}

std::optional<Error> SampleTimes::outside(const Domain& domain) const {
  const auto error = [&](double t, ErrorCode code, Where where) {
    const auto own_time = [&](double time) { return (key_epoch_ + Decimal::from_double(time)).to_string(); };
    return Error{code,
                 fmt::format("time {} is outside the curve, wanted {} to {}", own_time(t), own_time(domain.start),
                             own_time(domain.end)),
                 std::move(where)};
  };
  if (const auto* const list = std::get_if<List>(&times_)) {
    const auto& [times, lines] = list->list;
    const auto stray = std::ranges::find_if_not(times, [&](double t) { return domain.contains(t); });
    if (stray == times.end()) return std::nullopt;
    return error(*stray, ErrorCode::bad_data,
                 {.file = list->path, .line = lines[static_cast<std::size_t>(stray - times.begin())]});
  }
  for (const double t : {(*this)[0].t, (*this)[size_ - 1].t})
    if (!domain.contains(t)) return error(t, ErrorCode::bad_argument, {});
  return std::nullopt;
}

}  // namespace orispline::cli
