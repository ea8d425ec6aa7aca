// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/sample_grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto most = static_cast<std::uint64_t>(SampleGrid::most_samples);

/// How far from the end, in intervals, a sample is the one at the end that many intervals behind the start.
double end_tolerance(double intervals) {
  constexpr double in_intervals = 1e-9, relative = 4e-16;
  return in_intervals + relative * intervals;
}

}  // namespace

SampleGrid::SampleGrid(double start, Step step) : SampleGrid(Spacing(step), Decimal::from_double(start), start) {}

Expected<SampleGrid> SampleGrid::make(const Request& request, double curve_start, std::optional<double> curve_end) {
  const Decimal start = request.start.value_or(Decimal::from_double(curve_start));
  const Spacing spacing = std::visit([](const auto& given) { return Spacing(given); }, request.spacing);
  SampleGrid grid(spacing, start, start.to_double());
  if (!request.end && !curve_end) return grid;
  return end_of(request, start, request.end ? *request.end : Decimal::from_double(*curve_end)).map([&](const End& end) {
    grid.end_ = end;
    return grid;
  });
}

Expected<SampleGrid::End> SampleGrid::end_of(const Request& request, const Decimal& start, const Decimal& end) {
  End found{.time = end.to_double(), .span = (end - start).to_double(), .samples = 0};
  if (end < start) return found;
  if (const auto* const count = std::get_if<Count>(&request.spacing)) {
    if (count->samples > 1 && found.span == 0.0)
      return bad_option("count", formatted("found {} and a range that is the single time {}, wanted 1", count->samples,
                                           start.to_string()));
    found.samples = count->samples;
    found.index = found.samples - 1;
    return found;
  }
  const Rate rate = std::get<Rate>(request.spacing);
  const double exact = found.span * rate.hertz / rate.seconds, nearest = std::round(exact);
  const bool meets_end = std::abs(exact - nearest) <= end_tolerance(exact);
  const double intervals = meets_end ? nearest : std::floor(exact);
  if (!(intervals < most_samples))
    return bad_option("rate", formatted("{} makes {:.3g} samples over {} s, wanted fewer than {:.0e}",
                                        rate.per_second(), intervals, found.span, most_samples));
  const bool adds_end = !meets_end && request.last == LastSample::at_end;
  found.samples = static_cast<std::uint64_t>(intervals) + (adds_end ? 2 : 1);
  if (meets_end || adds_end) found.index = found.samples - 1;
  return found;
}

std::optional<std::uint64_t> SampleGrid::size() const noexcept {
  return end_ ? std::optional(end_->samples) : std::nullopt;
}

double SampleGrid::offset(std::uint64_t k) const noexcept {
  if (k == 0) return 0.0;
  if (end_ && k == end_->index) return end_->span;
  const auto steps = static_cast<double>(k);
  if (const auto* const rate = std::get_if<Rate>(&spacing_)) return steps * rate->seconds / rate->hertz;
  if (const auto* const step = std::get_if<Step>(&spacing_)) return steps * step->seconds / step->parts;
  const auto samples = static_cast<double>(std::get<Count>(spacing_).samples - 1);
  return end_ ? end_->span * steps / samples : infinity;
}

Instant SampleGrid::operator[](std::uint64_t k) const {
  const double behind = offset(k);
  if (std::holds_alternative<Step>(spacing_)) return {behind + start_seconds_, behind};
  if (end_ && behind == end_->span) return {end_->time, behind};
  return {std::isfinite(behind) ? start_.nearest_plus(behind) : behind, behind};
}

void SampleGrid::fill(std::uint64_t first, std::span<double> times) const {
  const auto write = [&](const auto& time_of) {
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = time_of(first + i);
  };
  const auto* const rate = std::get_if<Rate>(&spacing_);
  const auto* const count = std::get_if<Count>(&spacing_);
  const auto steps_of = [](std::uint64_t k) { return static_cast<double>(static_cast<std::int64_t>(k)); };
  const bool is_plain = start_.time() == Decimal() && end_ && end_->time == end_->span;
  if (is_plain && rate) {  // times are offsets: loops without calls, which compilers turn into vectors
    write([&steps_of, seconds = rate->seconds, hertz = rate->hertz](std::uint64_t k) {
      return steps_of(k) * seconds / hertz;
    });
  } else if (is_plain && count && count->samples > 1) {
    write([&steps_of, span = end_->span, intervals = static_cast<double>(count->samples - 1)](std::uint64_t k) {
      return span * steps_of(k) / intervals;
    });
  } else {
    return write([this](std::uint64_t k) { return (*this)[k].t; });
  }
  if (end_->index && first <= *end_->index && *end_->index - first < times.size())
    times[static_cast<std::size_t>(*end_->index - first)] = (*this)[*end_->index].t;
}

double SampleGrid::time(std::uint64_t k) const { return end_ && k >= end_->samples ? infinity : (*this)[k].t; }

/// Nearly always the sample that is looked for, or the one before it.
std::uint64_t SampleGrid::guess(double t, std::uint64_t limit) const noexcept {
  const double behind = t - start_seconds_;
  double k = 0.0;
  if (const auto* const rate = std::get_if<Rate>(&spacing_)) k = behind * rate->per_second();
  else if (const auto* const step = std::get_if<Step>(&spacing_)) k = behind / step->seconds * step->parts;
  else if (end_) k = behind / end_->span * static_cast<double>(limit - 1);
  return k > 0.0 ? static_cast<std::uint64_t>(std::min(std::floor(k), static_cast<double>(limit - 1))) : 0;
}

template <class Reached>
std::uint64_t SampleGrid::first_that(double t, Reached reached) const {
  std::uint64_t low = 0, high = size().value_or(most);
  if (high == 0) return 0;
  // Many samples have one time where steps are lost in rounding.
  const std::uint64_t near = guess(t, high);
  for (std::uint64_t k = near; k <= near + 1 && k < high; ++k)
    if (reached(time(k))) high = k;
    else low = k + 1;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (reached(time(middle))) high = middle;
    else low = middle + 1;
  }
  return low;
}

std::uint64_t SampleGrid::first_from(double t) const {
  return first_that(t, [t](double time) { return time >= t; });
}

std::uint64_t SampleGrid::first_after(double t) const {
  return first_that(t, [t](double time) { return time > t; });
}

std::uint64_t SampleGrid::settled_until(double t) const noexcept {
  if (end_) return end_->samples;
  const auto* const rate = std::get_if<Rate>(&spacing_);
  if (!rate) return std::holds_alternative<Step>(spacing_) ? most : 0;
  // Twice the tolerance of samples at the end, for the intervals are rounded here too.
  const double intervals = (t - start_seconds_) * rate->per_second();
  const double size = (std::abs(t) + std::abs(start_seconds_)) * rate->per_second();
  const double sure = std::ceil(intervals - 2.0 * end_tolerance(size));
  return sure > 0.0 ? static_cast<std::uint64_t>(std::min(sure, most_samples)) : 0;
}

}  // namespace orispline::inline ORISPLINE_ABI
