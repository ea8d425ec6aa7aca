// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/limited_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

MotionSizes bounds_of(const SegmentPeaks& peaks) {
  return {peaks.rate.bound, peaks.acceleration.bound, peaks.torque.bound};
}

MotionSizes found_of(const SegmentPeaks& peaks) {
  return {peaks.rate.found, peaks.acceleration.found, peaks.torque.found};
}

/// A segment that is slowed by itself is so near to its limits, where nothing else holds it.
constexpr double at_the_limit = 1.0 - 1e-3;
/// Bounds above this share of the limits are near enough to tell.
constexpr double near_the_limit = 1.0 - 1e-2;

MotionSizes operator*(double share, const MotionSizes& sizes) {
  return {share * sizes.rate, share * sizes.acceleration, share * sizes.torque};
}

MotionSizes sizes_of(const MotionLimits& limits) {
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  return {limits.rate.value_or(unlimited), limits.acceleration.value_or(unlimited), limits.torque.value_or(unlimited)};
}

}  // namespace

double needed_factor(const MotionSizes& peaks, const MotionLimits& limits) {
  double factor = 0.0;
  if (limits.rate) factor = std::max(factor, peaks.rate / *limits.rate);
  if (limits.acceleration) factor = std::max(factor, std::sqrt(peaks.acceleration / *limits.acceleration));
  if (limits.torque) factor = std::max(factor, std::sqrt(peaks.torque / *limits.torque));
  return factor;
}

Expected<AnyCurve> LimitedMotion::curve(std::vector<double> times) const {
  if (work_.stopped()) return cancellation();
  work_.add(1.0);
  return keys_.with_times(std::move(times)).and_then([this](const Keyframes& keys) {
    return make_curve(method_, keys);
  });
}

Expected<std::vector<SegmentPeaks>> LimitedMotion::certified(const AnyCurve& curve, const MotionSizes& floors) const {
  if (auto peaks = certified_peaks(curve, limits_.inertia, floors)) return std::move(*peaks);
  return failure(ErrorCode::bad_argument,
                 formatted("{}: no bounds are known for the segments of this method, wanted one of polynomials, "
                           "such as auto or timed-c2",
                           method_.name));
}

Expected<std::vector<double>> LimitedMotion::sampled_factors(std::vector<double> times) const {
  return curve(std::move(times)).transform([this](const AnyCurve& made) {
    std::vector<double> factors;
    for (const MotionSizes& peaks : sampled_peaks(made, limits_.inertia))
      factors.push_back(needed_factor(peaks, limits_));
    return factors;
  });
}

Expected<std::vector<double>> LimitedMotion::certified_factors(std::vector<double> times) const {
  return curve(std::move(times))
      .and_then([this](const AnyCurve& made) { return certified(made, sizes_of(limits_)); })
      .transform([this](const std::vector<SegmentPeaks>& peaks) {
        std::vector<double> factors;
        for (const SegmentPeaks& segment : peaks)
          factors.push_back(std::max(1.0, needed_factor(bounds_of(segment), limits_)));
        return factors;
      });
}

Expected<std::vector<SegmentPeaks>> LimitedMotion::largest_peaks(std::vector<double> times) const {
  return curve(std::move(times)).and_then([this](const AnyCurve& made) {
    const MotionSizes limits = sizes_of(limits_);
    MotionSizes floors = 1e-3 * limits;  // less matters to nobody
    for (const MotionSizes& peaks : sampled_peaks(made, limits_.inertia))
      floors = {std::max(floors.rate, peaks.rate), std::max(floors.acceleration, peaks.acceleration),
                std::max(floors.torque, peaks.torque)};
    return certified(made, floors);
  });
}

double LimitedMotion::largest_factor(std::span<const SegmentPeaks> peaks) const {
  double factor = 0.0;
  for (const SegmentPeaks& segment : peaks) factor = std::max(factor, needed_factor(bounds_of(segment), limits_));
  return factor;
}

double LimitedMotion::slack(std::span<const SegmentPeaks> peaks) const {
  double found = 0.0;
  for (const SegmentPeaks& segment : peaks) found = std::max(found, needed_factor(found_of(segment), limits_));
  return 1.0 - found;
}

Expected<double> LimitedMotion::largest_slack(std::vector<double> times) const {
  return curve(std::move(times))
      .and_then([this](const AnyCurve& made) { return certified(made, near_the_limit * sizes_of(limits_)); })
      .map([this](const std::vector<SegmentPeaks>& peaks) {
        std::optional<double> largest;
        for (const SegmentPeaks& segment : peaks)
          if (const double bound = needed_factor(bounds_of(segment), limits_); bound >= at_the_limit)
            largest = std::max(largest.value_or(0.0), 1.0 - needed_factor(found_of(segment), limits_) / bound);
        return largest.value_or(slack(peaks));
      });
}

}  // namespace orispline::inline ORISPLINE_ABI
