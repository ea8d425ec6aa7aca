// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/limited_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A segment that is slowed by itself is so near to its limits, where nothing else holds it.
constexpr double at_the_limit = 1.0 - 1e-3;
/// Bounds above this share of the limits are near enough to tell.
constexpr double near_the_limit = 1.0 - 1e-2;

QuantitySizes values_of(const SegmentPeaks& peaks, double CertifiedPeak::*member) {
  QuantitySizes sizes{};
  std::ranges::transform(peaks, sizes.begin(), [member](const CertifiedPeak& peak) { return peak.*member; });
  return sizes;
}

/// Segment by segment and quantity by quantity.
void add_largest(std::vector<SegmentPeaks>& all, std::vector<SegmentPeaks> more, std::size_t body) {
  for (SegmentPeaks& segment : more)
    for (CertifiedPeak& peak : segment) peak.body = body;
  if (all.empty()) {
    all = std::move(more);
    return;
  }
  for (std::size_t s = 0; s < all.size(); ++s)
    for (std::size_t k = 0; k < all[s].size(); ++k) {
      CertifiedPeak& largest = all[s][k];
      const CertifiedPeak& other = more[s][k];
      if (other.bound > largest.bound) largest.bound = other.bound, largest.body = body;
      if (other.found > largest.found) largest.found = other.found, largest.time = other.time;
    }
}

}  // namespace

LimitedMotion::LimitedMotion(const Method& method, std::span<const Keyframes> bodies, const MotionLimits& limits,
                             const StartingTimes& start, Rests rests, OpenEndedWork& work)
    : method_(method),
      bodies_(bodies),
      limits_(limits),
      start_(start),
      quantities_(quantities_of(limits)),
      work_(work) {
  for (std::size_t i = 0; i + 1 < bodies.front().size(); ++i)
    is_rest_.push_back(rests == Rests::kept && all_rest_after(bodies, i));
}

bool LimitedMotion::has_rests() const noexcept { return std::ranges::find(is_rest_, true) != is_rest_.end(); }

std::vector<double> LimitedMotion::lengthened(std::vector<double> times, double factor) const {
  const double first = times.front();
  double rested = 0.0, before = first;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double at = times[i];
    if (is_rest_[i - 1]) rested += at - before;
    before = at;
    times[i] = first + factor * ((at - first) - rested) + rested;
  }
  return times;
}

std::vector<double> LimitedMotion::shortened(std::vector<double> times, double factor) const {
  double before = times.front();
  for (std::size_t s = 0; s + 1 < times.size(); ++s) {
    const double interval = times[s + 1] - std::exchange(before, times[s + 1]);
    times[s + 1] = times[s] + (is_rest(s) ? interval : std::max(least_interval(s), factor * interval));
  }
  return times;
}

Expected<std::vector<PoseCurve>> LimitedMotion::curves(const std::vector<double>& times) const {
  if (work_.stopped()) return cancellation();
  work_.add(1.0);
  const bool moves = std::ranges::any_of(quantities_, &LimitedQuantity::is_of_position);
  std::vector<PoseCurve> all;
  for (const Keyframes& body : bodies_) {
    auto made = body.with_times(times).and_then([&](const Keyframes& keys) {
      if (moves) return make_pose_curve(method_, keys);
      return make_curve(method_, keys).map([](AnyCurve curve) { return PoseCurve{std::move(curve)}; });
    });
    if (!made) return tl::unexpected(std::move(made.error()));
    all.push_back(std::move(*made));
  }
  return all;
}

std::vector<QuantitySizes> LimitedMotion::sampled(const std::vector<PoseCurve>& curves) const {
  std::vector<QuantitySizes> largest(is_rest_.size(), QuantitySizes{});
  for (const PoseCurve& curve : curves) {
    const auto peaks = sampled_peaks(curve, wanted());
    for (std::size_t s = 0; s < largest.size(); ++s)
      std::ranges::transform(largest[s], peaks[s], largest[s].begin(),
                             [](double a, double b) { return std::max(a, b); });
  }
  return largest;
}

QuantitySizes LimitedMotion::limits_times(double share) const {
  QuantitySizes sizes{};
  std::ranges::transform(quantities_, sizes.begin(), [share](const LimitedQuantity& q) { return share * q.limit; });
  return sizes;
}

double LimitedMotion::factor_of_bounds(const SegmentPeaks& peaks) const {
  return needed_factor(values_of(peaks, &CertifiedPeak::bound), quantities_);
}
double LimitedMotion::factor_of_found(const SegmentPeaks& peaks) const {
  return needed_factor(values_of(peaks, &CertifiedPeak::found), quantities_);
}

Expected<std::vector<SegmentPeaks>> LimitedMotion::certified(const std::vector<PoseCurve>& curves,
                                                             const QuantitySizes& floors) const {
  std::vector<SegmentPeaks> largest;
  for (std::size_t body = 0; body < curves.size(); ++body) {
    auto peaks = certified_peaks(curves[body], wanted(), floors);
    if (!peaks)
      return failure(ErrorCode::bad_argument,
                     formatted("{}: no bounds are known for the segments of this method, wanted one of polynomials, "
                               "such as auto or timed-c2",
                               method_.name));
    add_largest(largest, std::move(*peaks), body);
  }
  return largest;
}

Expected<std::vector<double>> LimitedMotion::sampled_factors(std::vector<double> times) const {
  return curves(times).transform([this](const std::vector<PoseCurve>& made) {
    std::vector<double> factors;
    for (const QuantitySizes& peaks : sampled(made)) factors.push_back(needed_factor(peaks, quantities_));
    return factors;
  });
}

Expected<std::vector<double>> LimitedMotion::certified_factors(std::vector<double> times) const {
  return curves(times)
      .and_then([this](const std::vector<PoseCurve>& made) { return certified(made, limits_times(1.0)); })
      .transform([this](const std::vector<SegmentPeaks>& peaks) {
        std::vector<double> factors;
        for (const SegmentPeaks& segment : peaks) factors.push_back(std::max(1.0, factor_of_bounds(segment)));
        return factors;
      });
}

Expected<std::vector<SegmentPeaks>> LimitedMotion::largest_peaks(std::vector<double> times) const {
  return curves(times).and_then([this](const std::vector<PoseCurve>& made) {
    QuantitySizes floors = limits_times(1e-3);  // less matters to nobody
    for (const QuantitySizes& peaks : sampled(made))
      std::ranges::transform(floors, peaks, floors.begin(), [](double a, double b) { return std::max(a, b); });
    return certified(made, floors);
  });
}

double LimitedMotion::largest_factor(std::span<const SegmentPeaks> peaks) const {
  double factor = 0.0;
  for (const SegmentPeaks& segment : peaks) factor = std::max(factor, factor_of_bounds(segment));
  return factor;
}

double LimitedMotion::slack(std::span<const SegmentPeaks> peaks) const {
  double found = 0.0;
  for (const SegmentPeaks& segment : peaks) found = std::max(found, factor_of_found(segment));
  return 1.0 - found;
}

Expected<double> LimitedMotion::largest_slack(std::vector<double> times) const {
  return curves(times)
      .and_then([this](const std::vector<PoseCurve>& made) { return certified(made, limits_times(near_the_limit)); })
      .map([this](const std::vector<SegmentPeaks>& peaks) {
        std::optional<double> largest;
        for (const SegmentPeaks& segment : peaks)
          if (const double bound = factor_of_bounds(segment); bound >= at_the_limit)
            largest = std::max(largest.value_or(0.0), 1.0 - factor_of_found(segment) / bound);
        return largest.value_or(slack(peaks));
      });
}

}}  // namespace orispline
