// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/sample_grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/base/shortest_rest.hpp>
#include <orispline/batch/kernel/dispatch.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto most = static_cast<std::uint64_t>(SampleGrid::most_samples);

constexpr double exact_until = 0x1p53;  // sums and products of whole numbers are doubles as long as they stay below
constexpr double digits_until = 1e15;   // whole numbers below have 15 digits at most
constexpr int most_places = 22;         // 10^22 is the last power of ten that is a double

bool is_whole(double x) { return std::abs(x) < exact_until && x == std::nearbyint(x); }

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

std::optional<SampleGrid::Decimals> SampleGrid::decimals_of(const Spacing& spacing, const Decimal& start) {
  const auto* const rate = std::get_if<Rate>(&spacing);
  if (!rate || !(rate->hertz > 0.0 && rate->seconds > 0.0)) return std::nullopt;
  constexpr double finest = 0x1p10;
  double doubled = 1.0;  // 12.5 Hz are 25 in 2 s
  while (doubled < finest && !(is_whole(doubled * rate->hertz) && is_whole(doubled * rate->seconds))) doubled *= 2.0;
  const double hertz = doubled * rate->hertz, seconds = doubled * rate->seconds;
  if (!is_whole(hertz) || !is_whole(seconds)) return std::nullopt;
  double power = 1.0;
  for (int places = 0; places <= most_places && is_whole(power * seconds); ++places, power *= 10.0) {
    const Decimal shifted = start * Decimal::power_of_ten(places);
    if (!shifted.is_whole() || std::fmod(power * seconds, hertz) != 0.0) continue;
    return Decimals{shifted.to_double(), power * seconds / hertz, power, seconds};
  }
  return std::nullopt;
}

/// How the samples up to this one are computed without a look at each; absent where they are not.
///
/// By definition sample k is at the double nearest to the sum of the start and the shortest decimal of its offset. Of
/// decimals the offset is the double nearest to k step / 10^places: the quotient k seconds / hertz is rounded once
/// where k seconds is exact. Up to 15 digits different decimals have different doubles, so that this decimal, if it has
/// no more, is itself the shortest one. The sum is then (start + k step) / 10^places, rounded once where all of that is
/// exact.
std::optional<batch::EvenTimes> SampleGrid::even_until(std::uint64_t last) const {
  const auto k = static_cast<double>(last);
  if (decimals_ && k * decimals_->seconds < exact_until && k * decimals_->step < digits_until &&
      std::abs(decimals_->start) + k * decimals_->step < exact_until)
    return batch::EvenTimes{decimals_->step, decimals_->start, decimals_->power_of_ten};
  if (start_.time() != Decimal() || !end_ || end_->time != end_->span) return std::nullopt;
  // Times are offsets.
  if (const auto* const rate = std::get_if<Rate>(&spacing_)) return batch::EvenTimes{rate->seconds, 0.0, rate->hertz};
  const auto* const count = std::get_if<Count>(&spacing_);
  if (!count || count->samples < 2) return std::nullopt;
  return batch::EvenTimes{end_->span, 0.0, static_cast<double>(count->samples - 1)};
}

void SampleGrid::fill(std::uint64_t first, std::span<double> times) const {
  const std::size_t size = times.size();
  if (size == 0) return;
  if (const auto even = even_until(first + size - 1)) {
    batch::kernels().write_even_times(*even, static_cast<double>(first), size, times.data());
  } else if (const auto decimal = decimal_times(); decimal && first < most) {
    fill_by_decades(*decimal, first, times);
  } else {
    for (std::size_t i = 0; i < size; ++i) times[i] = (*this)[first + i].t;
  }
  if (end_ && end_->index && first <= *end_->index && *end_->index - first < size)
    times[static_cast<std::size_t>(*end_->index - first)] = (*this)[*end_->index].t;
}

/// Offsets as offset() computes them, but for those at the start and at the end; absent where they are not counted from
/// two halves.
std::optional<batch::DecimalTimes> SampleGrid::decimal_times() const {
  const auto& halves = start_.halves();
  if (!halves) return std::nullopt;
  if (const auto* const rate = std::get_if<Rate>(&spacing_))
    return batch::DecimalTimes{rate->seconds, rate->hertz, halves->high, halves->low};
  const auto* const count = std::get_if<Count>(&spacing_);
  if (!count || count->samples < 2 || !end_) return std::nullopt;
  return batch::DecimalTimes{end_->span, static_cast<double>(count->samples - 1), halves->high, halves->low};
}

void SampleGrid::fill_by_decades(const batch::DecimalTimes& wanted, std::uint64_t first,
                                 std::span<double> times) const {
  const std::uint64_t end = first + times.size();
  const auto begin_of = [&](int exponent) {  // the first sample of that decade or of a higher one
    std::uint64_t low = first, high = end;
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      if (static_cast<double>(middle) * wanted.factor / wanted.divisor < least_of_decade(exponent)) low = middle + 1;
      else high = middle;
    }
    return low;
  };
  const auto one_by_one = [&](std::uint64_t from, std::uint64_t to) {
    for (std::uint64_t k = from; k < to; ++k) times[static_cast<std::size_t>(k - first)] = (*this)[k].t;
  };
  std::uint64_t from = begin_of(lowest_decade);
  one_by_one(first, from);
  for (int exponent = lowest_decade; exponent <= highest_decade && from < end; ++exponent) {
    const std::uint64_t to = begin_of(exponent + 1);
    const auto part = times.subspan(static_cast<std::size_t>(from - first), static_cast<std::size_t>(to - from));
    const bool all_sure = batch::kernels().write_decimal_times(wanted, exponent, static_cast<double>(from), part.size(),
                                                               part.data()) == 0;
    for (std::size_t i = 0; !all_sure && i < part.size(); ++i)
      if (std::isnan(part[i])) part[i] = (*this)[from + i].t;
    from = to;
  }
  one_by_one(from, end);
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

}}  // namespace orispline
