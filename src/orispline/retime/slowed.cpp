// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/slowed.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <orispline/base/decimal.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/math/number.hpp>
#include <orispline/retime/interval_times.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double margin = 1e-9;  // of a factor, for the rounding of the new times; twice as much in every round
constexpr std::size_t most_slowings = 30;
constexpr double too_slow = 1e-6;  // so far below their limits, bounds ask for less slowing
constexpr int most_quickenings = 16;
constexpr double hurry = 0.8;             // of intervals that are shortened to start anew
constexpr double most_time_scale = 1e15;  // thirty million years a second

/// All intervals but rests made longer by one factor, and the peaks of the motion at these times.
struct Scaled {
  double factor;
  std::vector<double> times;
  std::vector<SegmentPeaks> peaks;
};

Expected<Scaled> scaled(const LimitedMotion& motion, std::vector<double> times, double factor) {
  times = factor < 1.0 ? motion.shortened(std::move(times), factor) : motion.lengthened(std::move(times), factor);
  return motion.largest_peaks(times).map([&](std::vector<SegmentPeaks> peaks) {
    return Scaled{factor, std::move(times), std::move(peaks)};
  });
}

/// A factor, and the one that is needed beyond it: below 1 where less would do.
struct Tried {
  double factor, more;
};

/// The factor between one that is too small and one that is enough at which hardly any is needed beyond it, if that
/// goes with a power of the factor.
double factor_between(const Tried& too_small, const Tried& enough) {
  using elementary::exponential, elementary::natural_logarithm;
  const double above = natural_logarithm(too_small.more), below = natural_logarithm(enough.more);
  const double way = (below + 0.5 * too_slow) / (below - above);
  return enough.factor * exponential(way * natural_logarithm(too_small.factor / enough.factor));
}

/// Less slowing where that does as well: the rounding of times loosens the bounds of fast motion, and slowed by them it
/// is slower than it has to be; a body that moves in rests, which keep their duration, moves otherwise at other
/// factors; and what intervals by themselves leave free is for all of them. `least`: of the factors.
Expected<Scaled> no_slower_than_needed(const LimitedMotion& motion, const std::vector<double>& given, double least,
                                       Scaled slow) {
  Tried enough{slow.factor, motion.largest_factor(slow.peaks)};
  std::optional<Tried> too_small;
  for (int round = 0; round < most_quickenings && enough.more < 1.0 - too_slow && enough.factor > least; ++round) {
    double factor = std::max(least, enough.factor * enough.more * (1.0 + margin));
    if (too_small)  // the middle now and then, where it goes with no power
      factor = round % 3 == 0 ? std::sqrt(too_small->factor * enough.factor) : factor_between(*too_small, enough);
    auto faster = scaled(motion, given, factor);
    if (!faster && faster.error().code == ErrorCode::cancelled) return faster;
    if (!faster || faster->times == slow.times) break;
    const Tried tried{factor, motion.largest_factor(faster->peaks)};
    if (tried.more > 1.0) too_small = tried;
    else enough = tried, slow = std::move(*faster);
    if (too_small && too_small->factor > (1.0 - too_slow) * enough.factor) break;
  }
  return slow;
}

/// Times to be made longer by the factor that is needed still, or shorter by one from `least` on.
struct Unscaled {
  std::vector<double> times;
  std::vector<SegmentPeaks> peaks;  ///< at these times
  double least;
  Slowing slowing;
};

Expected<Slowed> slowed(const LimitedMotion& motion, Unscaled start) {
  const auto time_scale = [&before = motion.starting_times()](const std::vector<double>& t) {
    return (t.back() - t.front()) / (before.back() - before.front());
  };
  const std::vector<double>& times = start.times;
  Expected<Scaled> slow = Scaled{1.0, times, std::move(start.peaks)};
  double more = margin;
  for (std::size_t round = 0; slow && round < most_slowings; ++round, more *= 2.0) {
    const double factor = motion.largest_factor(slow->peaks);
    if (!(factor > 1.0)) break;
    if (!(factor * time_scale(slow->times) <= most_time_scale))
      return failure(ErrorCode::bad_argument,
                     formatted("the limits ask for a slowing by {:.6g}, wanted limits that {:g} meets",
                               factor * time_scale(slow->times), most_time_scale));
    slow = scaled(motion, times, slow->factor * factor * (1.0 + more));
  }
  if (slow && slow->factor > start.least) slow = no_slower_than_needed(motion, times, start.least, std::move(*slow));
  if (!slow) return tl::unexpected(std::move(slow.error()));
  const double scale = time_scale(slow->times);
  if (motion.largest_factor(slow->peaks) > 1.0)
    return failure(ErrorCode::not_converged, formatted("no slowing up to {:.6g} meets the limits", scale));
  Expected<double> slack = 0.0;
  if (scale > 1.0)
    slack = start.slowing == Slowing::uniform ? Expected<double>(motion.slack(slow->peaks))
                                              : motion.largest_slack(slow->times);
  if (!slack) return tl::unexpected(std::move(slack.error()));
  return Slowed{std::move(slow->times), scale, *slack, start.slowing, std::move(slow->peaks)};
}

/// Each interval by itself, on the way down from these times.
Expected<Slowed> separately_slowed(const LimitedMotion& motion, std::vector<double> from, int support_keys,
                                   Slowing slowing) {
  return least_interval_times(motion, std::move(from), support_keys).and_then([&](std::vector<double> times) {
    return motion.largest_peaks(times).and_then([&](std::vector<SegmentPeaks> found) {
      return slowed(motion, {std::move(times), std::move(found), 0.0, slowing});
    });
  });
}

/// The fastest of several ways down, since each may end where no interval by itself can get shorter: from the starting
/// times, from the others, and once more from the best of these in a hurry.
Expected<Slowed> fastest_keys(const LimitedMotion& motion, int support_keys) {
  auto best = separately_slowed(motion, motion.starting_times(), support_keys, Slowing::fastest_keys);
  const auto go_down = [&](std::vector<double> from) {
    if (!best && best.error().code == ErrorCode::cancelled) return;
    auto other = separately_slowed(motion, std::move(from), support_keys, Slowing::fastest_keys);
    const bool is_cancelled = !other && other.error().code == ErrorCode::cancelled;
    if (is_cancelled || (other && (!best || other->time_scale < best->time_scale))) best = std::move(other);
  };
  for (const std::vector<double>& from : motion.other_times()) go_down(from);
  if (best) go_down(motion.shortened(best->times, hurry));
  return best;
}

}  // namespace

Expected<Slowed> least_slowed(const LimitedMotion& motion, int support_keys, Slowing slowing) {
  const std::vector<double>& given = motion.starting_times();
  if (slowing == Slowing::fastest_keys) return fastest_keys(motion, support_keys);
  auto peaks = motion.largest_peaks(given);
  if (!peaks) return tl::unexpected(std::move(peaks.error()));
  const bool is_slow = !(motion.largest_factor(*peaks) > 1.0);
  auto uniform = slowed(motion, {given, std::move(*peaks), 1.0, is_slow ? slowing : Slowing::uniform});
  if (slowing == Slowing::uniform || is_slow) return uniform;
  auto separate = separately_slowed(motion, given, support_keys, slowing);
  if (!separate && separate.error().code == ErrorCode::cancelled) return separate;
  return separate && (!uniform || separate->time_scale < (1.0 - least_gain) * uniform->time_scale) ? separate : uniform;
}

Slowed as_given(const LimitedMotion& motion) { return {motion.starting_times(), 1.0, 0.0, Slowing::uniform, {}}; }

double as_shown_or_more(double seconds) {
  const double last_digit = Decimal::power_of_ten(Decimal::from_double(seconds).decade() - 5).to_double();
  return std::ceil(seconds / last_digit) * last_digit;
}

Expected<Slowed> lasting(const LimitedMotion& motion, double duration) {
  const std::vector<double>& given = motion.starting_times();
  const double before = given.back() - given.front();
  double rested = 0.0;
  for (std::size_t s = 0; s + 1 < given.size(); ++s)
    if (motion.is_rest(s)) rested += given[s + 1] - given[s];
  const double factor = (duration - rested) / (before - rested);
  if (!(factor > 0.0) || !std::isfinite(factor))
    return bad_option("duration",
                      formatted("found {:.6g} s, and the rests alone take {:.6g} s of {:.6g} s; wanted more, "
                                "or `shorten_rests` as well",
                                duration, rested, before));
  std::vector<double> times = motion.lengthened(given, factor);
  times.back() = times.front() + duration;
  if (!motion.is_limited()) return Slowed{std::move(times), duration / before, 0.0, Slowing::uniform, {}};
  return motion.largest_peaks(times).and_then([&](std::vector<SegmentPeaks> peaks) -> Expected<Slowed> {
    const double more = motion.largest_factor(peaks);
    if (more > 1.0)
      return bad_option("duration",
                        formatted("in {:.6g} s the motion exceeds its limits, wanted some {:.6g} s at least", duration,
                                  as_shown_or_more(rested + more * (duration - rested))));
    return Slowed{std::move(times), duration / before, 0.0, Slowing::uniform, std::move(peaks)};
  });
}

Warning loose_bounds(std::string_view method, double slack) {
  return {.code = "loose_bounds",
          .message = formatted(
              "{}: the motion may be slower than the limits ask for, by a share of up to {:.2g}; keys that are "
              "very close in time make that happen, so join them into one",
              method, slack),
          .numbers = {{"slack", slack}}};
}

Warning longer_rests(std::string_view method) {
  return {
      .code = "longer_rests",
      .message = formatted("{}: the limits are met only where rests are slowed as well, so they are longer than they "
                           "were; equal keys that differ in their last digits make that happen",
                           method)};
}

}}  // namespace orispline
