// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <orispline/analysis/continuity.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/decimal.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/number.hpp>
#include <orispline/retime/even_motion.hpp>
#include <orispline/retime/inserted_keys.hpp>
#include <orispline/retime/interval_times.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Whether slowing can bring what is limited within limits at all: where a derivative jumps, the next one is infinite.
/// `order`: of the highest derivative that must not jump, 1 for ω, 2 for α.
Expected<void> check_continuity(const FamilyInfo& family, const Method& method, const Keyframes& keys, int order,
                                Slowing slowing) {
  const std::string_view jumping = order == 1 ? "angular velocity" : "angular acceleration",
                         limited = order == 1 ? "acceleration or torque" : "jerk";
  const auto refused = [&](std::string_view why, const std::string& wanted) {
    return failure(ErrorCode::bad_argument,
                   formatted("{}: its {} jumps at keys{}, which no slowing brings within a limit of {}, wanted {}",
                             family.name, jumping, why, limited, wanted));
  };
  const auto is_smooth_here = [&](std::string_view why, const std::string& wanted) {
    return make_curve(method, keys).and_then([&](const AnyCurve& curve) -> Expected<void> {
      if (continuity_at_keys(curve).order() >= order) return {};
      return refused(why, wanted);
    });
  };
  const bool as_promised = method.options.parameters.empty() && method.options.choices.empty();
  if (family.continuity_uneven >= order && as_promised) return {};
  if (family.continuity_uneven >= order)
    return is_smooth_here(" with these settings", formatted("others, with which it is C{}", order));
  if (family.continuity_uniform < order) return refused("", formatted("a method that is C{}, such as auto", order));
  if (slowing != Slowing::uniform)
    return refused(" whose times are uneven",
                   formatted("all intervals slowed alike, or a method that is C{} on any, such as auto", order));
  return is_smooth_here(" whose times are uneven, as these are",
                        formatted("even ones, or a method that is C{} on any, such as auto", order));
}

/// Whether keys of a method may get other times at all. Errors: those of retime().
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

/// Whether slowing can bring what is limited within limits: where a derivative jumps, the next one is infinite; and
/// whether there is a position where one is limited. Errors: those of retime().
Expected<void> check_limits(const FamilyInfo& family, const Method& method, const Keyframes& keys,
                            const RetimeOptions& options) {
  const MotionLimits& limits = options.limits;
  if (keys.positions().empty() && options.constant_speed)
    return bad_option("constant_speed", "the keys have no positions, wanted px,py,pz as well");
  if (keys.positions().empty() && limits.speed)
    return bad_option("max_speed", "the keys have no positions, wanted px,py,pz as well");
  if (keys.positions().empty() && limits.linear_acceleration)
    return bad_option("max_linear_acceleration", "the keys have no positions, wanted px,py,pz as well");
  const int order = limits.jerk ? 2 : limits.acceleration || limits.torque || limits.linear_acceleration ? 1 : 0;
  return order == 0 ? Expected<void>() : check_continuity(family, method, keys, order, options.slowing);
}

/// Whether a method's curve has room for more keys that do not change it by themselves.
Expected<void> check_insertion(const FamilyInfo& family, const Method& method, const Keyframes& keys,
                               const RetimeOptions& options) {
  if (options.insert_keys == 0) return {};
  if (!family.interpolates)
    return bad_option("insert_keys",
                      formatted("{}: its curve does not pass through its keys, so that more of them would "
                                "change it, wanted a method that does, such as auto",
                                family.name));
  const auto settings = settings_per_key(method, keys.size());
  if (!settings.empty())
    return bad_option("insert_keys", formatted("{} has a value for each key, and more keys have none, wanted one value "
                                               "for all",
                                               settings.begin()->first));
  return {};
}

constexpr double margin = 1e-9;  // of a factor, for the rounding of the new times; twice as much in every round
constexpr std::size_t most_slowings = 30;
constexpr double least_gain = 1e-4;  // of the duration, to which the slowing is the least one, for another path
constexpr double too_slow = 1e-6;    // so far below their limits, bounds ask for less slowing
constexpr int most_quickenings = 16;
constexpr double promised_slack = 2e-4;   // more is worth a warning
constexpr double usual_rounds = 3.0;      // of slowing all alike
constexpr double hurry = 0.8;             // of intervals that are shortened to start anew
constexpr double ways_down = 3.0;         // of the fastest keys
constexpr double most_time_scale = 1e15;  // thirty million years a second

/// Times at which the motion keeps its limits, as in Retiming.
struct Slowed {
  std::vector<double> times;
  double time_scale, slack;
  Slowing slowing;
  std::vector<SegmentPeaks> peaks;
};

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

/// The least slowing of the two, where both are asked for.
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

double seconds_of(const Track& track) { return track.keys.times().back() - track.keys.times().front(); }

bool is_even(const RetimeOptions& options) { return options.constant_rate || options.constant_speed; }

/// What an even motion is asked for besides. Error: bad_argument.
Expected<void> check_even(const RetimeOptions& options) {
  if (options.constant_rate && options.constant_speed)
    return bad_option("constant_rate", "found `constant_speed` as well, wanted one of them");
  const std::string_view asked = options.constant_rate ? "constant_rate" : "constant_speed";
  if (!quantities_of(options.limits).empty() || options.limits.inertia)
    return bad_option(asked, "it says how fast the motion is everywhere, wanted no limits beside it");
  if (options.duration) return bad_option(asked, "the duration follows from it, wanted no `duration` beside it");
  if (options.slowing != Slowing::uniform)
    return bad_option(asked, "the keys' times follow from it, wanted uniform slowing");
  return {};
}

/// At its own times, of which nothing is asked.
Slowed as_given(const LimitedMotion& motion) { return {motion.starting_times(), 1.0, 0.0, Slowing::uniform, {}}; }

/// To the six digits that are shown: shown rounded down it would not do.
double as_shown_or_more(double seconds) {
  const double last_digit = Decimal::power_of_ten(Decimal::from_double(seconds).decade() - 5).to_double();
  return std::ceil(seconds / last_digit) * last_digit;
}

/// Exactly that long, all intervals but rests scaled alike. Error (bad_argument): the rests alone are longer; a limit
/// is exceeded then.
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

std::vector<Warning> warnings_of(const Retiming& retiming, const MotionLimits& limits) {
  const Track& track = retiming.track;
  const Method& method = retiming.method;
  std::vector<Warning> warnings = limits.inertia ? orispline::warnings_of(*limits.inertia) : std::vector<Warning>();
  if (retiming.slack > promised_slack) warnings.push_back(loose_bounds(method.name, retiming.slack));
  std::ranges::move(orispline::warnings_of(method, track), std::back_inserter(warnings));
  return warnings;
}

/// What tracks are retimed by.
struct Task {
  const Method& method;
  const FamilyInfo& family;
  const RetimeOptions& options;
  OpenEndedWork& work;
};

/// More keys may make a slower motion, and take longer: fewer are tried too, in few intervals or in all.
std::vector<KeysPerInterval> counts_up_to(std::size_t most) {
  std::vector<KeysPerInterval> counts;
  for (std::size_t count = most; count > 0; count /= 2)
    for (const std::size_t inside : std::set<std::size_t>{0, (count + 1) / 3, count}) counts.push_back({count, inside});
  return counts;
}

double usual_curves(const FamilyInfo& family, const RetimeOptions& options) {
  if (options.slowing == Slowing::uniform) return usual_rounds;
  const double way_down = usual_rounds + curves_for_interval_times(family.support_keys);
  if (options.slowing == Slowing::per_interval) return way_down;
  return ways_down * way_down * (1.0 + static_cast<double>(counts_up_to(options.insert_keys).size()));
}

/// `others`: times from which the fastest keys may be sought as well.
Expected<Retiming> retimed(const Task& task, const Track& track, std::vector<std::vector<double>> others = {}) {
  const RetimeOptions& options = task.options;
  auto start = starting_times(track.keys, options);
  if (!start) return tl::unexpected(start.error());
  std::ranges::move(others, std::back_inserter(start->others));
  const auto slowed_with = [&](Rests rests) {
    const LimitedMotion motion(task.method, track.keys, options.limits, *start, rests, task.work);
    if (options.duration) return lasting(motion, *options.duration);
    if (!motion.is_limited()) return Expected<Slowed>(as_given(motion));
    return least_slowed(motion, task.family.support_keys, options.slowing);
  };
  auto slowed = slowed_with(Rests::kept);
  std::vector<std::size_t> rests = track.keys.rests();
  const bool slows_rests = !rests.empty() && !slowed && slowed.error().code == ErrorCode::not_converged;
  if (slows_rests) slowed = slowed_with(Rests::slowed);
  if (!slowed) return tl::unexpected(std::move(slowed.error()));
  return track.with_times(std::move(slowed->times)).map([&](Track later) {
    later.settings = settings_per_key(task.method, later.keys.size());
    later.recipe = recipe_for(task.method, later);
    Retiming retiming{.track = std::move(later),
                      .method = task.method,
                      .time_scale = slowed->time_scale,
                      .slack = slowed->slack,
                      .slowing = slowed->slowing,
                      .peaks = std::move(slowed->peaks),
                      .rests = std::move(rests)};
    if (options.shorten_rests || options.duration || options.slowing == Slowing::fastest_keys)
      retiming.time_scale = seconds_of(retiming.track) / seconds_of(track);
    retiming.warnings = warnings_of(retiming, options.limits);
    if (slows_rests) retiming.warnings.push_back(longer_rests(task.method.name));
    return retiming;
  });
}

/// The track with more keys.
Track with_more_keys(const Track& track, const MoreKeys& more) {
  Track denser(more.keys);
  denser.name = track.name;
  denser.epoch = track.epoch;
  denser.is_dated = track.is_dated;
  if (track.as_read.empty()) return denser;
  denser.as_read.assign(more.keys.orientations().begin(), more.keys.orientations().end());
  auto read = track.as_read.begin();
  for (std::size_t i = 0; i < more.keys.size(); ++i)
    if (!std::ranges::binary_search(more.inserted, i)) denser.as_read[i] = *read++;
  return denser;
}

/// The fastest of what was found and of the same with more keys on its curve.
Expected<Retiming> with_keys_inserted(const Task& task, const Track& track, Retiming few) {
  const auto path = make_pose_curve(task.method, few.track.keys);
  if (!path) return tl::unexpected(path.error());
  Retiming best = few;
  for (const KeysPerInterval& count : counts_up_to(task.options.insert_keys)) {
    const auto more = with_more_keys(few.track.keys, *path, count);
    if (!more || more->inserted.empty()) continue;
    const auto times = more->keys.times();
    auto found = retimed(task, with_more_keys(few.track, *more), {{times.begin(), times.end()}});
    if (!found && found.error().code == ErrorCode::cancelled) return found;
    if (!found || !(seconds_of(found->track) < (1.0 - least_gain) * seconds_of(best.track))) continue;
    best = std::move(*found);
    best.inserted = more->inserted;
  }
  best.time_scale = seconds_of(best.track) / seconds_of(track);
  return best;
}

}  // namespace

Method holding_rests(Method method, const Keyframes& keys) {
  const auto family = family_of_method(method);
  if (!family || std::ranges::find((*family)->parameters, "hold", &Parameter::name) == (*family)->parameters.end())
    return method;
  if (!keys.rests().empty()) method.options.parameters.insert({"hold", {1.0}});
  return method;
}

Expected<void> check(const RetimeOptions& options) {
  if (auto checked = check_ranges(options); !checked) return checked;
  if (options.insert_keys > 0 && options.slowing != Slowing::fastest_keys)
    return bad_option("insert_keys", "it makes the fastest keys faster, wanted `fastest_keys` as well");
  if (is_even(options)) return check_even(options);
  if (options.ease || options.path_times != PathTimes::lengths)
    return bad_option(options.ease ? "ease" : "path_times",
                      "it is of an even motion, wanted `constant_rate` or `constant_speed` as well");
  const MotionLimits& limits = options.limits;
  const bool needs_limit = options.slowing == Slowing::fastest_keys || (!options.duration && !options.shorten_rests);
  if (quantities_of(limits).empty() && needs_limit)
    return failure(ErrorCode::bad_argument,
                   "found no limit, wanted `max_rate`, `max_acceleration`, `max_jerk`, `max_torque`, `max_speed`, "
                   "`max_linear_acceleration`, `duration`, `constant_rate` or `constant_speed`");
  if (options.duration && options.slowing != Slowing::uniform)
    return bad_option("duration", "it scales all intervals alike, wanted uniform slowing");
  if (limits.torque && !limits.inertia)
    return bad_option("max_torque", "the torque depends on the body, wanted `inertia` as well");
  if (limits.inertia && !limits.torque)
    return bad_option("inertia", "it is used for the torque alone, wanted `max_torque` as well");
  if (!limits.inertia) return {};
  return checked_inertia(*limits.inertia).map([](const auto&) {});
}

Expected<Retiming> retime(const Track& track, const Method& given, const RetimeOptions& options,
                          const Progress& progress) {
  const auto family = family_of_method(given);
  if (!family) return tl::unexpected(family.error());
  const Method method = completed(given, **family, track);
  const auto checked = check(options)
                           .and_then([&] { return check_motion(**family, method, track.keys); })
                           .and_then([&] { return check_limits(**family, method, track.keys, options); })
                           .and_then([&] { return check_insertion(**family, method, track.keys, options); });
  if (!checked) return tl::unexpected(checked.error());
  if (is_even(options)) return evenly_retimed(track, method, options, progress);
  OpenEndedWork work(progress, usual_curves(**family, options));
  const Task task{method, **family, options, work};
  return retimed(task, track)
      .and_then([&](Retiming retiming) {
        return options.insert_keys > 0 ? with_keys_inserted(task, track, std::move(retiming))
                                       : Expected<Retiming>(retiming);
      })
      .map([&](Retiming retiming) {
        work.finish();
        return retiming;
      });
}

}}  // namespace orispline
