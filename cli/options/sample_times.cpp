// SPDX-License-Identifier: Apache-2.0
#include "options/sample_times.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/io/times_file.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

using Rate = SampleGrid::Rate;
using Count = SampleGrid::Count;
using Spacing = std::variant<Rate, Count, TimesFile>;

Rate rate_of(const Fraction& per_second) {
  return {per_second.numerator().to_double(), per_second.denominator().to_double()};
}

Expected<Spacing> spacing_in(const TimeOptions& options, const io::Clock& clock) {
  const int given = options.rate.has_value() + options.count.has_value() + options.list.has_value();
  if (given == 0 && clock.frames_per_second) return Spacing(rate_of(*clock.frames_per_second));
  if (given != 1)
    return usage_failure(formatted("found {} of --rate, --count and --times, wanted one of them, such as --rate 100",
                                   given == 0 ? "none" : std::to_string(given)));
  if (options.list) return Spacing(TimesFile{.path = *options.list, .reading = {.clock = clock}});
  if (options.count)
    return count_in({"--count", *options.count}, 1).map([](std::size_t n) { return Spacing(Count{n}); });
  constexpr std::string_view what = "a number of samples per second greater than 0";
  const OptionText rate = without_unit({"--rate", *options.rate}, "Hz");
  if (rate.text.find('/') == std::string_view::npos)
    return positive_in(rate, what).map([](double hertz) { return Spacing(Rate{hertz}); });
  return fraction_in(rate, what).map([](const Fraction& per_second) { return Spacing(rate_of(per_second)); });
}

/// `5`, or `+5` since the first key.
auto bound_in(const io::Clock& clock) {
  return [&clock](OptionText option) -> Expected<TimeBound> {
    option = without_unit(option, "s");
    const bool since_first_key = option.text.starts_with('+');
    auto time = io::time_in(option.text.substr(since_first_key ? 1 : 0), clock);
    if (time) return TimeBound{*time, since_first_key};
    time.error().code = ErrorCode::bad_argument;
    time.error().message = formatted("{}: {}", option.option, time.error().message);
    return tl::unexpected(std::move(time.error()));
  };
}

constexpr double most_samples = 1e9;

Warning outside(std::string_view side, const TimeBound& bound, std::string_view verb, const Decimal& end,
                std::string_view held) {
  return {
      .code = "outside_curve",
      .message = formatted("--{} {} lies outside the curve, which {} at {} s; samples there hold the {} orientation; "
                           "write +T for a time T seconds after the first key",
                           side, bound.time.to_string(), verb, end.to_string(), held)};
}

}  // namespace

TimeRequest anchored(TimeRequest request, const Decimal& key_epoch) {
  for (auto* const bound : {&request.from, &request.to})
    if (*bound && (*bound)->since_first_key) *bound = TimeBound{key_epoch + (*bound)->time};
  return request;
}

Expected<void> check_number(const TimeRequest& request, double samples) {
  if (request.any_number || samples <= most_samples) return {};
  return usage_failure(
      formatted("found a request for {:.4g} samples, wanted {:g} at most: check the rate and the unit of "
                "the times; 'orispline sample --yes' writes any number",
                samples, most_samples));
}

std::vector<Warning> range_warnings(const TimeRequest& request, const Decimal& key_epoch, const Domain& domain) {
  const Decimal start = key_epoch + Decimal::from_double(domain.start),
                end = key_epoch + Decimal::from_double(domain.end);
  std::vector<Warning> warnings;
  if (request.from && request.from->time < start)
    warnings.push_back(outside("from", *request.from, "begins", start, "first"));
  if (request.from && request.from->time > end) warnings.push_back(outside("from", *request.from, "ends", end, "last"));
  if (request.to && request.to->time < start) warnings.push_back(outside("to", *request.to, "begins", start, "first"));
  if (request.to && request.to->time > end) warnings.push_back(outside("to", *request.to, "ends", end, "last"));
  return warnings;
}

Expected<TimeRequest> time_request(const TimeOptions& options, const io::Clock& clock) {
  using Last = SampleGrid::LastSample;
  FirstError checked;
  TimeRequest request{.spacing = checked(spacing_in(options, clock)),
                      .from = checked(if_given("--from", options.from, bound_in(clock))),
                      .to = checked(if_given("--to", options.to, bound_in(clock))),
                      .last = options.include_end ? Last::at_end : Last::before_end,
                      .any_number = options.yes};
  auto read = std::move(checked).or_else(std::move(request));
  if (read && options.include_end && !std::holds_alternative<Rate>(read->spacing))
    return usage_failure(options.list
                             ? "--include-end: found --times, whose file says which times to sample; wanted --rate"
                             : "--include-end: found --count, which includes both ends already; wanted --rate");
  if (read && options.list && (options.from || options.to))
    return usage_failure("--times: its file says which times to sample; wanted neither --from nor --to");
  if (read && read->from && read->to && read->from->since_first_key == read->to->since_first_key &&
      read->from->time > read->to->time)
    return usage_failure(formatted("--from {} is after --to {}", *options.from, *options.to));
  return read;
}

std::optional<SampleGrid::Request> grid_request(const TimeRequest& request, const Decimal& key_epoch) {
  const auto since_epoch = [&](const std::optional<TimeBound>& bound) {
    return bound ? std::optional(bound->time - key_epoch) : std::nullopt;
  };
  SampleGrid::Request wanted{
      .spacing = Rate{}, .start = since_epoch(request.from), .end = since_epoch(request.to), .last = request.last};
  if (std::holds_alternative<TimesFile>(request.spacing)) return std::nullopt;
  if (const auto* const rate = std::get_if<Rate>(&request.spacing)) wanted.spacing = *rate;
  else wanted.spacing = std::get<Count>(request.spacing);
  return wanted;
}

Expected<void> check_range(const TimeRequest& request, const Decimal& key_epoch, double curve_start,
                           std::optional<double> curve_end) {
  const Decimal start = request.from ? request.from->time : key_epoch + Decimal::from_double(curve_start);
  if (request.to && !request.from && request.to->time < start)
    return usage_failure(formatted("--to {} is before the start at {}, wanted --from as well",
                                   request.to->time.to_string(), start.to_string()));
  if (!request.to && !curve_end) return {};
  const Decimal end = request.to ? request.to->time : key_epoch + Decimal::from_double(*curve_end);
  if (start > end && request.from && request.to)
    return usage_failure(formatted("--from {} is after --to {}", start.to_string(), end.to_string()));
  if (request.from && start > end)
    return usage_failure(formatted("--from {} is after the end at {}, wanted --to as well",
                                   request.from->time.to_string(), end.to_string()));
  if (const auto* const count = std::get_if<Count>(&request.spacing); count && count->samples > 1 && start == end)
    return usage_failure(formatted("--count: found {} and a range that is the single time {}, wanted 1", count->samples,
                                   start.to_string()));
  return {};
}

SampleTimes::SampleTimes(const Decimal& key_epoch, const SampleGrid::Request& request, double curve_start,
                         const SampleGrid& grid)
    : key_epoch_(key_epoch),
      origin_(key_epoch + request.start.value_or(Decimal::from_double(curve_start))),
      times_(grid) {}

Expected<SampleTimes> SampleTimes::make(const TimeRequest& request, const Decimal& key_epoch, const Domain& domain) {
  if (const auto wanted = grid_request(request, key_epoch))
    return check_range(request, key_epoch, domain.start, domain.end)
        .and_then([&] { return SampleGrid::make(*wanted, domain.start, domain.end); })
        .and_then([&](const SampleGrid& grid) {
          return check_number(request, static_cast<double>(*grid.size())).map([&] { return grid; });
        })
        .map([&](const SampleGrid& grid) { return SampleTimes(key_epoch, *wanted, domain.start, grid); });
  const auto& [path, reading] = std::get<TimesFile>(request.spacing);
  return io::read_times(path, key_epoch, reading).map([&, path = path](io::TimesList list) {
    return SampleTimes(key_epoch, List{path, std::move(list)});
  });
}

std::size_t SampleTimes::size() const noexcept {
  const auto* const list = std::get_if<List>(&times_);
  return list ? list->list.times.size() : static_cast<std::size_t>(*std::get<SampleGrid>(times_).size());
}

std::vector<Warning> SampleTimes::warnings() const {
  const auto* const list = std::get_if<List>(&times_);
  return list ? list->list.warnings : std::vector<Warning>();
}

Instant SampleTimes::operator[](std::size_t k) const {
  if (const auto* const list = std::get_if<List>(&times_)) return {list->list.times[k], list->list.times[k]};
  return std::get<SampleGrid>(times_)[k];
}

std::optional<Error> SampleTimes::fault_as_keys() const {
  const auto own_time = [&](double time) { return (key_epoch_ + Decimal::from_double(time)).to_string(); };
  if ((*this)[0].t < 0.0 && !std::holds_alternative<List>(times_))
    return Error{
        ErrorCode::bad_argument,
        formatted("--from: found {} before the first key at {}, where a file of skeletons begins; wanted a time "
                  "from there on",
                  own_time((*this)[0].t), key_epoch_.to_string())};
  const auto* const list = std::get_if<List>(&times_);
  if (!list) return std::nullopt;
  const auto& times = list->list.times;
  const auto fault = [&](std::size_t i, std::string message) {
    return Error{ErrorCode::bad_data, std::move(message), {.file = list->path, .line = list->list.lines[i]}};
  };
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < 0.0)
      return fault(i, formatted("found time {} before the first key at {}, where a file of skeletons begins; wanted a "
                                "time from there on",
                                own_time(times[i]), key_epoch_.to_string()));
    if (i == 0 || static_cast<float>(times[i]) > static_cast<float>(times[i - 1])) continue;
    return fault(i, formatted("found time {} after {}, wanted increasing times{}: they are the keys of a file of "
                              "skeletons",
                              own_time(times[i]), own_time(times[i - 1]),
                              times[i] > times[i - 1] ? " that single precision tells apart" : ""));
  }
  return std::nullopt;
}

std::optional<Error> SampleTimes::outside(const Domain& domain) const {
  const auto error = [&](double t, ErrorCode code, Where where) {
    const auto own_time = [&](double time) { return (key_epoch_ + Decimal::from_double(time)).to_string(); };
    return Error{code,
                 formatted("time {} is outside the curve, wanted {} to {}", own_time(t), own_time(domain.start),
                           own_time(domain.end)),
                 std::move(where)};
  };
  if (const auto* const list = std::get_if<List>(&times_)) {
    const std::vector<double>& times = list->list.times;
    const std::vector<std::uint32_t>& lines = list->list.lines;
    const auto stray = std::ranges::find_if_not(times, [&](double t) { return domain.contains(t); });
    if (stray == times.end()) return std::nullopt;
    return error(*stray, ErrorCode::bad_data,
                 {.file = list->path, .line = lines[static_cast<std::size_t>(stray - times.begin())]});
  }
  for (const double t : {(*this)[0].t, (*this)[size() - 1].t})
    if (!domain.contains(t)) return error(t, ErrorCode::bad_argument, {});
  return std::nullopt;
}

}  // namespace orispline::cli
