// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/retime/motion_limits.hpp>
#include <orispline/retime/rate_bounds.hpp>
#include <orispline/retime/starting_times.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What becomes of rests between equal keys.
enum class Rests { kept, slowed };

/// A method's curves through keys whose times are free, beside the limits that each of them shall keep: of a body, or
/// of several that share their times, such as the joints of a skeleton. Refers to its arguments.
class LimitedMotion {
 public:
  LimitedMotion(const Method& method, std::span<const Keyframes> bodies, const MotionLimits& limits,
                const StartingTimes& start, Rests rests, OpenEndedWork& work);
  LimitedMotion(Method&&, std::span<const Keyframes>, const MotionLimits&, const StartingTimes&, Rests,
                OpenEndedWork&) = delete;

  [[nodiscard]] const std::vector<double>& starting_times() const noexcept { return start_.times; }
  /// Other times from which a descent may begin.
  [[nodiscard]] const std::vector<std::vector<double>>& other_times() const noexcept { return start_.others; }
  /// What a segment may be cut to [s].
  [[nodiscard]] double least_interval(std::size_t segment) const noexcept { return start_.least[segment]; }
  /// Whether all rest on a segment, which has its duration already.
  [[nodiscard]] bool is_rest(std::size_t segment) const noexcept { return is_rest_[segment]; }
  [[nodiscard]] bool has_rests() const noexcept;
  [[nodiscard]] bool is_limited() const noexcept { return !quantities_.empty(); }
  /// The times with all segments but the rests longer by that factor.
  [[nodiscard]] std::vector<double> lengthened(std::vector<double> times, double factor) const;
  /// The same with a factor below 1, which brings no segment below its least_interval().
  [[nodiscard]] std::vector<double> shortened(std::vector<double> times, double factor) const;

  /// The factor that every segment needs at these times [s], by samples.
  [[nodiscard]] Expected<std::vector<double>> sampled_factors(std::vector<double> times) const;
  /// The factor that every segment needs at these times, by bounds; 1 where none is needed.
  [[nodiscard]] Expected<std::vector<double>> certified_factors(std::vector<double> times) const;
  /// The peaks at these times; the bounds of those that are the largest of the curve are near.
  [[nodiscard]] Expected<std::vector<SegmentPeaks>> largest_peaks(std::vector<double> times) const;
  /// The largest of the factors, by bounds; below 1 where the motion could be faster.
  [[nodiscard]] double largest_factor(std::span<const SegmentPeaks> peaks) const;
  /// By which share the motion might be shorter still, for the largest values that were found lie below the limits.
  [[nodiscard]] double slack(std::span<const SegmentPeaks> peaks) const;
  /// slack() where every segment is slowed by itself: of the one at a limit at these times where it is the largest, by
  /// its bounds; of all where none is at a limit.
  [[nodiscard]] Expected<double> largest_slack(std::vector<double> times) const;

 private:
  [[nodiscard]] Expected<std::vector<PoseCurve>> curves(const std::vector<double>& times) const;
  /// The largest of all curves, segment by segment.
  [[nodiscard]] std::vector<QuantitySizes> sampled(const std::vector<PoseCurve>& curves) const;
  [[nodiscard]] Expected<std::vector<SegmentPeaks>> certified(const std::vector<PoseCurve>& curves,
                                                              const QuantitySizes& floors) const;
  [[nodiscard]] MotionQuantities wanted() const noexcept { return {quantities_, limits_.inertia}; }
  [[nodiscard]] QuantitySizes limits_times(double share) const;
  [[nodiscard]] double factor_of_bounds(const SegmentPeaks& peaks) const;
  [[nodiscard]] double factor_of_found(const SegmentPeaks& peaks) const;

  const Method& method_;
  std::span<const Keyframes> bodies_;
  const MotionLimits& limits_;
  const StartingTimes& start_;
  std::vector<LimitedQuantity> quantities_{};
  std::vector<bool> is_rest_{};
  OpenEndedWork& work_;  ///< every curve is a piece of it; when it is stopped, none is made any more
};

}}  // namespace orispline
