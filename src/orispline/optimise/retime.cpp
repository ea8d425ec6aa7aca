// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/retime.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <orispline/families/registry.hpp>

namespace orispline::optimise {
namespace {

constexpr double margin = 1e-9;  // of a factor, for the rounding of the new times
constexpr std::size_t most_rounds = 60;

Expected<void> check(const FamilyInfo& family, const Keyframes& keys, const MotionLimits& limits) {
  const auto refused = [](std::string message) { return failure(ErrorCode::bad_argument, std::move(message)); };
  if (!limits.rate && !limits.acceleration && !limits.torque) return refused("found no limit, wanted one at least");
  for (const auto& limit : {limits.rate, limits.acceleration, limits.torque})
    if (limit && !(*limit > 0.0 && std::isfinite(*limit)))
      return refused(fmt::format("found the limit {:.6g}, wanted more than 0", *limit));
  if (limits.torque && !limits.inertia) return refused("found a limit of torque without an inertia, wanted both");
  if (family.rate_orders > 0)
    return refused(fmt::format("{}: this method takes rates from the keys, wanted one that has its own", family.name));
  if (family.continuity_uneven < 1 && (limits.acceleration || limits.torque))
    return refused(
        fmt::format("{}: its angular velocity jumps at keys, which no slowing brings within a limit of "
                    "acceleration or torque, wanted a method that is C1, such as auto",
                    family.name));
  if (keys.size() < 2) return failure(ErrorCode::bad_data, "found 1 key, wanted 2 at least: one key does not move");
  return {};
}

/// A thousandth of a limit matters to nobody.
PeakFloors floors_of(const MotionLimits& limits) {
  const auto floor = [](const std::optional<double>& limit) {
    return limit ? 1e-3 * *limit : std::numeric_limits<double>::infinity();
  };
  return {floor(limits.rate), floor(limits.acceleration), floor(limits.torque)};
}

/// By which factor a segment must be slowed: ω goes with 1/s, α and torque with 1/s².
double factor_of(const SegmentPeaks& peaks, const MotionLimits& limits) {
  double factor = 1.0;
  if (limits.rate) factor = std::max(factor, peaks.rate.bound / *limits.rate);
  if (limits.acceleration) factor = std::max(factor, std::sqrt(peaks.acceleration.bound / *limits.acceleration));
  if (limits.torque) factor = std::max(factor, std::sqrt(peaks.torque.bound / *limits.torque));
  return factor;
}

double largest_factor(const std::vector<SegmentPeaks>& peaks, const MotionLimits& limits) {
  double factor = 1.0;
  for (const SegmentPeaks& segment : peaks) factor = std::max(factor, factor_of(segment, limits));
  return factor;
}

/// Keys at times of their own, and the peaks of the curve through them.
class TimedKeys {
 public:
  TimedKeys(std::string_view method, const Keyframes& keys, const MotionLimits& limits)
      : method_(method), keys_(keys), limits_(limits) {}

  [[nodiscard]] Expected<std::vector<SegmentPeaks>> peaks(const std::vector<double>& times) const {
    KeyframeData data{.times = times, .orientations = {keys_.orientations().begin(), keys_.orientations().end()}};
    const auto curve = Keyframes::make(std::move(data), Signs::as_given).and_then([&](const Keyframes& keys) {
      return make_curve(method_, keys);
    });
    if (!curve) return tl::unexpected(curve.error());
    auto found = certified_peaks(*curve, limits_.inertia, floors_of(limits_));
    if (found) return std::move(*found);
    return failure(ErrorCode::bad_argument,
                   fmt::format("{}: no bounds are known for the segments of this method, wanted one of polynomials, "
                               "such as auto or timed-c2",
                               method_));
  }

  /// All intervals stretched by the factor that is needed still.
  [[nodiscard]] Expected<Retiming> slowed(std::vector<double> times) const {
    auto found = peaks(times);
    for (std::size_t round = 0; found && round < most_rounds; ++round) {
      const double factor = largest_factor(*found, limits_);
      if (!(factor > 1.0)) break;
      for (double& t : times) t = times.front() + factor * (1.0 + margin) * (t - times.front());
      found = peaks(times);
    }
    if (!found) return tl::unexpected(std::move(found.error()));
    const auto before = keys_.times();
    const double stretch = (times.back() - times.front()) / (before.back() - before.front());
    if (largest_factor(*found, limits_) > 1.0)
      return failure(ErrorCode::not_converged, fmt::format("no slowing up to {:.6g} meets the limits", stretch));
    return Retiming{std::move(times), stretch, std::move(*found)};
  }

  /// Every interval stretched by what it needs and, so that steps stay alike, by the root of what its neighbours need.
  [[nodiscard]] Expected<std::vector<double>> slowed_by_interval(std::vector<double> times) const {
    for (std::size_t round = 0; round < most_rounds; ++round) {
      const auto found = peaks(times);
      if (!found) return tl::unexpected(found.error());
      if (!(largest_factor(*found, limits_) > 1.0 + 1e-6)) break;
      std::vector<double> next{times.front()};
      for (std::size_t s = 0; s < found->size(); ++s) {
        double factor = factor_of((*found)[s], limits_);
        if (s > 0) factor = std::max(factor, std::sqrt(factor_of((*found)[s - 1], limits_)));
        if (s + 1 < found->size()) factor = std::max(factor, std::sqrt(factor_of((*found)[s + 1], limits_)));
        next.push_back(next.back() + factor * (times[s + 1] - times[s]));
      }
      times = std::move(next);
    }
    return times;
  }

 private:
  std::string_view method_;
  const Keyframes& keys_;
  const MotionLimits& limits_;
};

}  // namespace

Expected<Retiming> retime(std::string_view method, const Keyframes& keys, const MotionLimits& limits, Slowing slowing) {
  const auto family = find_family(method);
  if (!family) return tl::unexpected(family.error());
  if (auto checked = check(**family, keys, limits); !checked) return tl::unexpected(std::move(checked.error()));
  const TimedKeys timed(method, keys, limits);
  const std::vector<double> times(keys.times().begin(), keys.times().end());
  auto uniform = timed.slowed(times);
  if (!uniform || slowing == Slowing::uniform) return uniform;
  auto separate = timed.slowed_by_interval(times).and_then([&](std::vector<double> t) { return timed.slowed(t); });
  return separate && separate->stretch < uniform->stretch ? separate : uniform;
}

}  // namespace orispline::optimise
