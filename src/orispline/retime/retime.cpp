// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/retime/even_motion.hpp>
#include <orispline/retime/inserted_keys.hpp>
#include <orispline/retime/interval_times.hpp>
#include <orispline/retime/retimed_method.hpp>
#include <orispline/retime/slowed.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

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
  auto start = starting_times({&track.keys, 1}, options);
  if (!start) return tl::unexpected(start.error());
  std::ranges::move(others, std::back_inserter(start->others));
  const auto slowed_with = [&](Rests rests) {
    const LimitedMotion motion(task.method, {&track.keys, 1}, options.limits, *start, rests, task.work);
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
  const auto checked =
      check(options).and_then([&] { return check_retimed(**family, method, track.keys, options); }).and_then([&] {
        return check_insertion(**family, method, track.keys, options);
      });
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
