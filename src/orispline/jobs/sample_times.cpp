// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/sample_times.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr double most_samples = 1e9;

Warning outside(std::string_view side, const TimeBound& bound, std::string_view verb, const Decimal& end,
                std::string_view held) {
  return {
      .code = "outside_curve",
      .message = formatted("`{}` {} lies outside the curve, which {} at {} s; samples there hold the {} orientation; "
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
  return failure(ErrorCode::bad_argument,
                 formatted("found a request for {:.4g} samples, wanted {:g} at most: check the rate and the unit of "
                           "the times{}{}",
                           samples, most_samples, request.cure.empty() ? "" : "; ", request.cure));
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

std::optional<SampleGrid::Request> grid_request(const TimeRequest& request, const Decimal& key_epoch) {
  const auto since_epoch = [&](const std::optional<TimeBound>& bound) {
    return bound ? std::optional(bound->time - key_epoch) : std::nullopt;
  };
  SampleGrid::Request wanted{.spacing = SampleGrid::Rate{},
                             .start = since_epoch(request.from),
                             .end = since_epoch(request.to),
                             .last = request.last};
  if (std::holds_alternative<ReadTimes>(request.spacing)) return std::nullopt;
  if (const auto* const rate = std::get_if<SampleGrid::Rate>(&request.spacing)) wanted.spacing = *rate;
  else wanted.spacing = std::get<SampleGrid::Count>(request.spacing);
  return wanted;
}

Expected<void> check_range(const TimeRequest& request, const Decimal& key_epoch, double curve_start,
                           std::optional<double> curve_end) {
  const Decimal start = request.from ? request.from->time : key_epoch + Decimal::from_double(curve_start);
  if (request.to && !request.from && request.to->time < start)
    return failure(ErrorCode::bad_argument, formatted("`to` {} is before the start at {}, wanted `from` as well",
                                                      request.to->time.to_string(), start.to_string()));
  if (!request.to && !curve_end) return {};
  const Decimal end = request.to ? request.to->time : key_epoch + Decimal::from_double(*curve_end);
  if (start > end && request.from && request.to)
    return failure(ErrorCode::bad_argument,
                   formatted("`from` {} is after `to` {}", start.to_string(), end.to_string()));
  if (request.from && start > end)
    return failure(ErrorCode::bad_argument, formatted("`from` {} is after the end at {}, wanted `to` as well",
                                                      request.from->time.to_string(), end.to_string()));
  if (const auto* const count = std::get_if<SampleGrid::Count>(&request.spacing);
      count && count->samples > 1 && start == end)
    return failure(ErrorCode::bad_argument,
                   formatted("`count`: found {} and a range that is the single time {}, wanted 1", count->samples,
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
  return std::get<ReadTimes>(request.spacing)(key_epoch).map(
      [&](ListedTimes list) { return SampleTimes(key_epoch, std::move(list)); });
}

std::size_t SampleTimes::size() const noexcept {
  const auto* const list = std::get_if<ListedTimes>(&times_);
  return list ? list->times.size() : static_cast<std::size_t>(*std::get<SampleGrid>(times_).size());
}

std::vector<Warning> SampleTimes::warnings() const {
  const auto* const list = std::get_if<ListedTimes>(&times_);
  return list ? list->warnings : std::vector<Warning>();
}

Instant SampleTimes::operator[](std::size_t k) const {
  if (const auto* const list = std::get_if<ListedTimes>(&times_)) return {list->times[k], list->times[k]};
  return std::get<SampleGrid>(times_)[k];
}

void SampleTimes::fill(std::size_t first, std::span<double> times, std::span<double> offsets) const {
  if (const auto* const list = std::get_if<ListedTimes>(&times_)) {
    std::ranges::copy(std::span(list->times).subspan(first, times.size()), times.begin());
    std::ranges::copy(times, offsets.begin());
    return;
  }
  const auto& grid = std::get<SampleGrid>(times_);
  grid.fill(first, times);
  for (std::size_t k = 0; k < offsets.size(); ++k) offsets[k] = grid.offset(first + k);
}

std::optional<Error> SampleTimes::fault_as_keys() const {
  const auto own_time = [&](double time) { return (key_epoch_ + Decimal::from_double(time)).to_string(); };
  if ((*this)[0].t < 0.0 && !std::holds_alternative<ListedTimes>(times_))
    return Error{
        ErrorCode::bad_argument,
        formatted("`from`: found {} before the first key at {}, where a file of skeletons begins; wanted a time "
                  "from there on",
                  own_time((*this)[0].t), key_epoch_.to_string())};
  const auto* const list = std::get_if<ListedTimes>(&times_);
  if (!list) return std::nullopt;
  const auto& times = list->times;
  const auto fault = [&](std::size_t i, std::string message) {
    return Error{ErrorCode::bad_data, std::move(message), {.file = list->file, .line = list->lines[i]}};
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
  if (const auto* const list = std::get_if<ListedTimes>(&times_)) {
    const std::vector<double>& times = list->times;
    const std::vector<std::uint32_t>& lines = list->lines;
    const auto stray = std::ranges::find_if_not(times, [&](double t) { return domain.contains(t); });
    if (stray == times.end()) return std::nullopt;
    return error(*stray, ErrorCode::bad_data,
                 {.file = list->file, .line = lines[static_cast<std::size_t>(stray - times.begin())]});
  }
  for (const double t : {(*this)[0].t, (*this)[size() - 1].t})
    if (!domain.contains(t)) return error(t, ErrorCode::bad_argument, {});
  return std::nullopt;
}

Expected<TimesOnCurve> times_on_curve(const TimeRequest& request, const Decimal& key_epoch, const Domain& domain,
                                      Extrapolation extrapolation) {
  const TimeRequest wanted = anchored(request, key_epoch);
  auto times = SampleTimes::make(wanted, key_epoch, domain);
  if (!times) return tl::unexpected(std::move(times.error()));
  if (extrapolation == Extrapolation::error)
    if (auto stray = times->outside(domain)) return tl::unexpected(std::move(*stray));
  auto warnings = times->warnings();
  if (extrapolation == Extrapolation::hold)
    std::ranges::move(range_warnings(wanted, key_epoch, domain), std::back_inserter(warnings));
  return TimesOnCurve{std::move(*times), std::move(warnings)};
}

}}}  // namespace orispline::jobs
