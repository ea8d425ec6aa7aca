// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/torque.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/recipe.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/retime/interval_times.hpp>
#include <orispline/retime/retime_fields.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr double margin = 1e-9;  // of a factor, for the rounding of the new times; twice as much in every round
constexpr std::size_t most_slowings = 30;
constexpr double least_gain = 1e-4;  // of the duration, to which the slowing is the least one, for another path
constexpr double too_slow = 1e-5;    // so far below their limits, bounds ask for less slowing
constexpr int most_quickenings = 4;
constexpr double promised_slack = 2e-4;   // more is worth a warning
constexpr double usual_rounds = 3.0;      // of slowing all alike
constexpr double most_time_scale = 1e15;  // thirty million years a second

Expected<void> check_motion(const FamilyInfo& family, const Method& method, const Keyframes& keys) {
  const auto refused = [](std::string message) { return failure(ErrorCode::bad_argument, std::move(message)); };
  if (family.rate_orders > 0)
    return refused(formatted("{}: this method takes rates from the keys, wanted one that has its own", family.name));
  if (method.options.loop) return refused(formatted("{}: loops are not slowed, wanted an open curve", family.name));
  for (const End& end : {method.options.start, method.options.end})
    if (!end.angular_velocity.isZero(0.0))
      return refused(
          formatted("{}: found a rate at an end, which slowing would change, wanted an end rule without "
                    "one, such as natural or rest",
                    family.name));
  if (keys.size() < 2) return failure(ErrorCode::bad_data, "found 1 key, wanted 2 at least: one key does not move");
  return {};
}

/// Whether slowing can bring accelerations within limits at all.
Expected<void> check_continuity(const FamilyInfo& family, const Method& method, const Keyframes& keys,
                                Slowing slowing) {
  const auto refused = [&](std::string_view why, std::string_view wanted) {
    return failure(ErrorCode::bad_argument,
                   formatted("{}: its angular velocity jumps at keys{}, which no slowing brings within a limit of "
                             "acceleration or torque, wanted {}",
                             family.name, why, wanted));
  };
  const auto is_smooth_here = [&](std::string_view why, std::string_view wanted) {
    return make_curve(method, keys).and_then([&](const AnyCurve& curve) -> Expected<void> {
      if (continuity_at_keys(curve).order() >= 1) return {};
      return refused(why, wanted);
    });
  };
  const bool as_promised = method.options.parameters.empty() && method.options.choices.empty();
  if (family.continuity_uneven >= 1 && as_promised) return {};
  if (family.continuity_uneven >= 1) return is_smooth_here(" with these settings", "others, with which it is C1");
  if (family.continuity_uniform < 1) return refused("", "a method that is C1, such as auto");
  if (slowing == Slowing::per_interval)
    return refused(" whose times are uneven",
                   "all intervals slowed alike, or a method that is C1 on any, such as auto");
  return is_smooth_here(" whose times are uneven, as these are",
                        "even ones, or a method that is C1 on any, such as auto");
}

/// Times at which the motion keeps its limits, as in Retiming.
struct Slowed {
  std::vector<double> times;
  double time_scale, slack;
  Slowing slowing;
  std::vector<SegmentPeaks> peaks;
};

/// All intervals made longer by one factor, and the peaks of the motion at these times.
struct Scaled {
  double factor;
  std::vector<double> times;
  std::vector<SegmentPeaks> peaks;
};

Expected<Scaled> scaled(const LimitedMotion& motion, std::vector<double> times, double factor) {
  for (double& t : times) t = times.front() + factor * (t - times.front());
  return motion.largest_peaks(times).map([&](std::vector<SegmentPeaks> peaks) {
    return Scaled{factor, std::move(times), std::move(peaks)};
  });
}

/// Less slowing where that does as well: the rounding of times loosens the bounds of fast motion, and slowed by them it
/// is slower than it has to be.
Expected<Scaled> no_slower_than_needed(const LimitedMotion& motion, const std::vector<double>& given, Scaled slow) {
  double factor = slow.factor * motion.largest_factor(slow.peaks) * (1.0 + margin);
  for (int round = 0; round < most_quickenings && factor < (1.0 - too_slow) * slow.factor; ++round) {
    auto faster = scaled(motion, given, std::max(1.0, factor));
    if (!faster && faster.error().code == ErrorCode::cancelled) return faster;
    if (!faster) break;
    const double more = motion.largest_factor(faster->peaks);
    if (!(more > 1.0)) return faster;
    factor *= more * (1.0 + margin);
  }
  return slow;
}

/// All intervals made longer by the factor that is needed still; `found`: the peaks at these times.
Expected<Slowed> slowed(const LimitedMotion& motion, const std::vector<double>& times, std::vector<SegmentPeaks> found,
                        Slowing slowing) {
  const auto time_scale = [before = motion.given_times()](const std::vector<double>& t) {
    return (t.back() - t.front()) / (before.back() - before.front());
  };
  Expected<Scaled> slow = Scaled{1.0, times, std::move(found)};
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
  if (slow && slow->factor > 1.0 && slowing == Slowing::uniform)
    slow = no_slower_than_needed(motion, times, std::move(*slow));
  if (!slow) return tl::unexpected(std::move(slow.error()));
  const double scale = time_scale(slow->times);
  if (motion.largest_factor(slow->peaks) > 1.0)
    return failure(ErrorCode::not_converged, formatted("no slowing up to {:.6g} meets the limits", scale));
  Expected<double> slack = 0.0;
  if (scale > 1.0)
    slack =
        slowing == Slowing::uniform ? Expected<double>(motion.slack(slow->peaks)) : motion.largest_slack(slow->times);
  if (!slack) return tl::unexpected(std::move(slack.error()));
  return Slowed{std::move(slow->times), scale, *slack, slowing, std::move(slow->peaks)};
}

/// The least slowing of the two, where both are asked for.
Expected<Slowed> least_slowed(const LimitedMotion& motion, int support_keys, Slowing slowing) {
  const std::vector<double> given(motion.given_times().begin(), motion.given_times().end());
  auto peaks = motion.largest_peaks(given);
  if (!peaks) return tl::unexpected(std::move(peaks.error()));
  const bool is_slow = !(motion.largest_factor(*peaks) > 1.0);
  auto uniform = slowed(motion, given, std::move(*peaks), is_slow ? slowing : Slowing::uniform);
  if (slowing == Slowing::uniform || is_slow) return uniform;
  auto separate = least_interval_times(motion, support_keys).and_then([&](std::vector<double> times) {
    return motion.largest_peaks(times).and_then([&](std::vector<SegmentPeaks> found) {
      return slowed(motion, times, std::move(found), Slowing::per_interval);
    });
  });
  if (!separate && separate.error().code == ErrorCode::cancelled) return separate;
  return separate && (!uniform || separate->time_scale < (1.0 - least_gain) * uniform->time_scale) ? separate : uniform;
}

Warning loose_bounds(std::string_view method, double slack) {
  return {.code = "loose_bounds",
          .message = formatted("{}: the largest values that were found lie below the limits, and {:.2g} less slowing "
                               "might do; keys that are very close together in time make that happen",
                               method, slack),
          .numbers = {{"slack", slack}}};
}

}  // namespace

Expected<void> check(const RetimeOptions& options) {
  if (auto checked = check_ranges(options); !checked) return checked;
  const MotionLimits& limits = options.limits;
  if (!limits.rate && !limits.acceleration && !limits.torque)
    return failure(ErrorCode::bad_argument, "found no limit, wanted `max_rate`, `max_acceleration` or `max_torque`");
  if (limits.torque && !limits.inertia) return bad_option("max_torque", "wanted `inertia` as well");
  if (limits.inertia && !limits.torque) return bad_option("inertia", "wanted `max_torque` as well");
  if (!limits.inertia) return {};
  return checked_inertia(*limits.inertia).map([](const auto&) {});
}

Expected<Retiming> retime(const Track& track, const Method& given, const RetimeOptions& options,
                          const Progress& progress) {
  const auto family = find_family(given.name);
  if (!family) return tl::unexpected(family.error());
  const Method method = completed(given, **family, track);
  const MotionLimits& limits = options.limits;
  const auto checked = check(options).and_then([&] { return check_motion(**family, method, track.keys); });
  if (!checked) return tl::unexpected(checked.error());
  if (limits.acceleration || limits.torque)
    if (auto smooth = check_continuity(**family, method, track.keys, options.slowing); !smooth)
      return tl::unexpected(std::move(smooth.error()));
  const bool per_interval = options.slowing == Slowing::per_interval;
  OpenEndedWork work(progress,
                     usual_rounds + (per_interval ? curves_for_interval_times((*family)->support_keys) : 0.0));
  const LimitedMotion motion(method, track.keys, limits, work);
  return least_slowed(motion, (*family)->support_keys, options.slowing).and_then([&](Slowed slowed) {
    return track.with_times(std::move(slowed.times)).map([&](Track later) {
      later.settings = settings_per_key(method, later.keys.size());
      later.recipe = recipe_for(method, later);
      work.finish();
      std::vector<Warning> warnings = limits.inertia ? warnings_of(*limits.inertia) : std::vector<Warning>();
      if (slowed.slack > promised_slack) warnings.push_back(loose_bounds(method.name, slowed.slack));
      std::ranges::move(warnings_of(method, later), std::back_inserter(warnings));
      return Retiming{.track = std::move(later),
                      .method = method,
                      .time_scale = slowed.time_scale,
                      .slack = slowed.slack,
                      .slowing = slowed.slowing,
                      .peaks = std::move(slowed.peaks),
                      .warnings = std::move(warnings)};
    });
  });
}

}  // namespace orispline::inline ORISPLINE_ABI
