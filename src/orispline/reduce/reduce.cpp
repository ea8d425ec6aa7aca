// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/reduce.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/base/counted_work.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/families/slerp.hpp>
#include <orispline/reduce/cubic_keys.hpp>
#include <orispline/reduce/fewest_geodesics.hpp>
#include <orispline/reduce/hermite_keys.hpp>
#include <orispline/reduce/key_search.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double usual_curves = 100.0;        // that are tried
constexpr double smallest_tolerance = 1e-12;  // [rad]: far above the rounding of orientations

Expected<LocalMethod> local_method(const Method& given, const Track& recording) {
  const auto family = family_of_method(given);
  if (!family) return tl::unexpected(family.error());
  const FamilyInfo& info = **family;
  const auto refused = [&](std::string_view what) {
    return failure(ErrorCode::bad_argument, formatted("{}: {}", info.name, what));
  };
  if (info.support_keys == all_keys || !info.interpolates)
    return failure(ErrorCode::bad_argument,
                   formatted("{}: found a method {}, wanted a local one through its keys, such as auto", info.name,
                             info.interpolates ? "that depends on all keys" : "that passes near its keys"));
  const CurveOptions& options = given.options;
  if (options.loop) return refused("loops are not reduced, wanted an open curve");
  const std::size_t keys = std::max(
      {static_cast<std::size_t>(info.min_keys), keys_needed(options.start.rule), keys_needed(options.end.rule)});
  if (keys > 2)
    return refused(
        formatted("with these ends it needs {} keys, wanted an end rule that needs 2, such as natural", keys));
  if (auto settled = settle(info, options, recording.keys.size()); !settled)
    return tl::unexpected(std::move(settled.error()));
  return LocalMethod{completed(given, info, recording), static_cast<std::size_t>(info.support_keys + 1) / 2};
}

/// [m]: far above the rounding of positions; 0 where there are none.
double smallest_position_tolerance(const Keyframes& recording) {
  double largest = 0.0;
  for (const Eigen::Vector3d& position : recording.positions()) largest = std::max(largest, position.norm());
  return 64.0 * std::numeric_limits<double>::epsilon() * largest;
}

Expected<void> check(const Keyframes& recording, const Tolerance& tolerance) {
  if (!(tolerance.angle >= smallest_tolerance))
    return bad_option("tolerance", formatted("found {:.6g} rad, wanted {:.0e} rad at least: the "
                                             "rounding of orientations is not much smaller",
                                             tolerance.angle, smallest_tolerance));
  if (!(tolerance.position > 0.0))
    return bad_option("position_tolerance", formatted("found {:.6g} m, wanted more than 0", tolerance.position));
  if (const double smallest = smallest_position_tolerance(recording); !(tolerance.position >= smallest))
    return bad_option("position_tolerance", formatted("found {:.6g} m, wanted {:.1e} m at least: the rounding of these "
                                                      "positions is not much smaller",
                                                      tolerance.position, smallest));
  if (recording.size() < 2) return failure(ErrorCode::bad_data, "found 1 sample, wanted 2 or more");
  return {};
}

/// Of `hermite-c1`, with their rates.
Expected<KeySet> keys_with_rates(const ToleranceCheck& recording) {
  const Keyframes& samples = recording.samples();
  const RotationChannel channel{.times = {samples.times().begin(), samples.times().end()},
                                .values = {samples.orientations().begin(), samples.orientations().end()}};
  HermiteKeys found =
      fewest_hermite_keys(cubic_samples(channel, BetweenSamples::smooth), recording.tolerance().angle - angle_rounding,
                          {}, [&] { return recording.stopped(); });
  if (recording.stopped()) return cancellation();
  KeySet keys = recording.keys_at(std::move(found.samples));
  keys.angular_velocities = std::move(found.rates);
  return keys;
}

Expected<KeySet> chosen_keys(const LocalMethod& method, const ToleranceCheck& recording, KeyValues values) {
  if (seeks_rates(method.method) && values == KeyValues::sampled && !recording.bounds_positions())
    return keys_with_rates(recording);
  if (method.method.name != families::Slerp::info.name) return selected_keys(method, recording);
  auto samples = fewest_geodesics(recording);
  if (recording.stopped()) return cancellation();
  return recording.keys_at(std::move(samples));
}

/// With the deviation of what was found, measured anew.
Expected<Reduction> certified(const LocalMethod& local, const ToleranceCheck& recording, const Track& track,
                              KeySet found) {
  const Method method = local.method.at(found.samples, recording.size());
  auto keys = recording.keyframes(found);
  if (!keys) return tl::unexpected(std::move(keys.error()));
  const auto deviation = recording.deviation(method, *keys);
  if (!deviation) return tl::unexpected(deviation.error());
  const Tolerance tolerance = recording.tolerance();
  const auto missed = [&](double distance, double wanted, std::string_view unit) {
    return failure(ErrorCode::bad_argument,
                   formatted("{}: the curve is {:.6g} {} from a sample, wanted {:.6g} {}: the tolerance is below "
                             "rounding",
                             method.name, distance, unit, wanted, unit));
  };
  if (deviation->angle > tolerance.angle) return missed(deviation->angle, tolerance.angle, "rad");
  if (deviation->position.value_or(0.0) > tolerance.position)
    return missed(*deviation->position, tolerance.position, "m");
  Track reduced = track.at(found.samples).with_keys(*keys);
  reduced.settings = settings_per_key(method, found.samples.size());
  reduced.recipe = recipe_for(method, reduced);
  return Reduction{std::move(reduced), method, std::move(found.samples), *deviation};
}

/// [s]; infinite where there is none. A jump is no gap.
double shortest_gap(const Keyframes& keys, std::span<const Stretch> stretches) {
  const auto t = keys.times();
  double shortest = std::numeric_limits<double>::infinity();
  for (const Stretch& stretch : stretches.subspan(1))
    if (!is_jump(t, stretch.first)) shortest = std::min(shortest, t[stretch.first] - t[stretch.first - 1]);
  return shortest;
}

/// The interval from which on those between these keys are gaps and no others, the stated one if it is; absent where
/// there is none such.
std::optional<double> telling_gap(const Keyframes& keys, std::span<const Stretch> stretches,
                                  std::optional<double> gap) {
  const auto t = keys.times();
  double longest = 0.0;
  for (const auto& [first, count] : stretches)
    for (std::size_t i = first + 1; i < first + count; ++i) longest = std::max(longest, t[i] - t[i - 1]);
  const double shortest = shortest_gap(keys, stretches);
  if (gap && longest > *gap) gap = std::midpoint(longest, shortest);
  const bool tells = gap && std::isfinite(*gap) && longest < shortest && stretches_between_gaps(t, gap).has_value();
  return tells ? gap : std::nullopt;
}

Expected<Reduction> reduced(const Track& track, const Method& method, const ReduceOptions& options,
                            const Progress& progress);

/// Samples among which no two neighbours are as far apart as the limit [s]; those in between are as late as may be.
std::vector<std::size_t> nearer_than(double limit, std::span<const double> t, const std::vector<std::size_t>& samples) {
  std::vector<std::size_t> nearer{samples.front()};
  for (const std::size_t next : samples) {
    for (std::size_t i = nearer.back() + 1; i < next; ++i)
      if (t[i + 1] - t[nearer.back()] >= limit) nearer.push_back(i);
    if (next > nearer.back()) nearer.push_back(next);
  }
  return nearer;
}

/// With as many samples more as it takes that no interval looks like a gap, where the curve keeps to the tolerance.
Reduction told_from_gaps(Reduction reduction, const Track& track, const Method& method, const ReduceOptions& options,
                         double shortest_gap) {
  const auto samples = nearer_than(shortest_gap, track.keys.times(), reduction.samples);
  const bool are_samples = options.values == KeyValues::sampled && reduction.track.keys.angular_velocities().empty();
  if (!are_samples || samples.size() == reduction.samples.size()) return reduction;
  const auto local = local_method(method, track);
  if (!local) return reduction;
  OpenEndedWork work({}, usual_curves);
  const ToleranceCheck recording(track.keys, options.tolerance, work);
  auto denser = certified(*local, recording, track, recording.keys_at(samples));
  return denser ? std::move(*denser) : std::move(reduction);
}

/// A stretch of one sample stays as it is.
Expected<Reduction> reduced_stretch(const Track& track, const Method& method, const ReduceOptions& options,
                                    const Stretch& stretch, double shortest_gap, const Progress& progress) {
  std::vector<std::size_t> samples(stretch.count);
  std::iota(samples.begin(), samples.end(), stretch.first);
  auto own = keys_of_stretch(track.keys, stretch);
  if (!own) return tl::unexpected(std::move(own.error()));
  Track part = track.at(samples).with_keys(*own);
  if (stretch.count == 1) return Reduction{.track = std::move(part), .samples = {0}};
  part.recipe.signs = track.recipe.signs;
  const Method for_stretch = method_for_stretch(method, stretch, track.keys.size());
  return reduced(part, for_stretch, options, progress).map([&](Reduction reduction) {
    return told_from_gaps(std::move(reduction), part, for_stretch, options, shortest_gap);
  });
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// The worse of two deviations, the second of which is of samples from that one on.
Deviation worse(Deviation one, const Deviation& other, std::size_t first) {
  if (other.angle > one.angle) one.angle = other.angle, one.angle_at = first + other.angle_at;
  if (other.position && !(*other.position <= one.position.value_or(-1.0)))
    one.position = other.position, one.position_at = first + other.position_at;
  return one;
}

/// The keys of several stretches in one track; a key that stands alone has no rates of its own.
void append_keys(KeyframeData& all, const Reduction& one, bool have_rates) {
  const KeyframeData& more = one.track.keys.data();
  append(all.times, more.times);
  append(all.orientations, more.orientations);
  append(all.positions, more.positions);
  if (!have_rates) return;
  if (one.samples.size() > 1) append(all.angular_velocities, more.angular_velocities);
  else all.angular_velocities.push_back(free_rate());
}

/// Each stretch by itself, and all their keys in one track, the recipe of which states the gaps where one length can.
Expected<Reduction> reduced_in_stretches(const Track& track, const Method& method, const ReduceOptions& options,
                                         const Progress& progress) {
  const auto stretches = stretches_of(track);
  if (!stretches) return tl::unexpected(stretches.error());
  const auto local = local_method(method, track);
  if (!local) return tl::unexpected(local.error());
  const double shortest = shortest_gap(track.keys, *stretches);
  std::vector<Reduction> each;
  Reduction all;
  for (const Stretch& stretch : *stretches) {
    auto one = reduced_stretch(track, method, options, stretch, shortest, progress);
    if (!one) return one;
    all.stretches.push_back({all.samples.size(), one->samples.size()});
    for (const std::size_t sample : one->samples) all.samples.push_back(stretch.first + sample);
    all.deviation = worse(all.deviation, one->deviation, stretch.first);
    each.push_back(std::move(*one));
  }
  const bool have_rates = std::ranges::any_of(each, [](const Reduction& one) {
    return one.samples.size() > 1 && !one.track.keys.angular_velocities().empty();
  });
  KeyframeData data{.jumps = true};
  for (const Reduction& one : each) append_keys(data, one, have_rates);
  auto keys = Keyframes::make(std::move(data), Signs::as_given);
  if (!keys) return tl::unexpected(std::move(keys.error()));
  all.method = local->method.at(all.samples, track.keys.size());
  all.track = track.at(all.samples).with_keys(*keys);
  all.track.settings = settings_per_key(all.method, all.samples.size());
  all.track.recipe = recipe_for(all.method, all.track);
  all.track.recipe.gap = telling_gap(all.track.keys, all.stretches, track.recipe.gap);
  return all;
}

}  // namespace

Expected<Reduction> reduce(const Track& track, const Method& method, const ReduceOptions& options,
                           const Progress& progress) {
  return are_in_stretches(track.keys, track.recipe.gap) ? reduced_in_stretches(track, method, options, progress)
                                                        : reduced(track, method, options, progress);
}

namespace {

Expected<Reduction> reduced(const Track& track, const Method& method, const ReduceOptions& options,
                            const Progress& progress) {
  const auto local = local_method(method, track);
  if (!local) return tl::unexpected(local.error());
  if (const auto checked = check(track.keys, options.tolerance); !checked) return tl::unexpected(checked.error());
  OpenEndedWork work(progress, usual_curves);
  const ToleranceCheck recording(track.keys, options.tolerance, work);
  return chosen_keys(*local, recording, options.values)
      .and_then([&](KeySet keys) -> Expected<KeySet> {
        if (options.values == KeyValues::sampled) return keys;
        return with_keys_refitted(*local, recording, std::move(keys));
      })
      .and_then([&](KeySet keys) { return certified(*local, recording, track, std::move(keys)); })
      .map([&](Reduction reduction) {
        work.finish();
        return reduction;
      });
}

}  // namespace

std::vector<Expected<std::vector<Reduction>>> reduce_tracks(std::span<const Track> tracks,
                                                            std::span<const Method> methods,
                                                            const ReduceOptions& options, unsigned threads,
                                                            const Progress& progress) {
  std::vector<std::optional<Expected<Reduction>>> found(tracks.size() * methods.size());
  CountedWork work(progress, found.size());
  parallel_for(found.size(), threads, [&](std::size_t i) {
    found[i] = reduce(tracks[i / methods.size()], methods[i % methods.size()], options, {.stop = progress.stop});
    work.add_part();
  });
  std::vector<Expected<std::vector<Reduction>>> of_tracks(tracks.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    auto& track = of_tracks[i / methods.size()];
    if (!track) continue;
    if (*found[i]) track->push_back(std::move(**found[i]));
    else track = tl::unexpected(std::move(found[i]->error()));
  }
  return of_tracks;
}

Expected<PoseCurve> curve_of(const Reduction& reduction) {
  return reduction.stretches.empty() ? make_pose_curve(reduction.method, reduction.track.keys)
                                     : curve_in_stretches(reduction.method, reduction.track.keys, reduction.stretches);
}

Expected<DistanceStatistics> distance_of(const Reduction& reduction, const Keyframes& samples,
                                         std::span<const std::size_t> left_out) {
  std::vector<std::size_t> kept;
  std::vector<double> times;
  std::vector<Eigen::Quaterniond> orientations;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (std::ranges::binary_search(left_out, i)) continue;
    kept.push_back(i);
    times.push_back(samples.times()[i]);
    orientations.push_back(samples.orientations()[i]);
  }
  return curve_of(reduction).map([&](const PoseCurve& curve) {
    DistanceStatistics distance = distance_to_reference(curve.orientation, {times, orientations});
    if (distance.count > 0) distance.largest_at = kept[distance.largest_at];
    return distance;
  });
}

Expected<DistanceStatistics> position_distance_of(const Reduction& reduction, const Keyframes& samples,
                                                  std::span<const std::size_t> left_out) {
  return curve_of(reduction).map([&](const PoseCurve& curve) {
    std::vector<std::size_t> kept;
    std::vector<double> distances;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (std::ranges::binary_search(left_out, i)) continue;
      kept.push_back(i);
      const auto t = samples.times();
      const Side side = i + 1 < t.size() && t[i] == t[i + 1] ? Side::left : Side::right;  // of a jump
      distances.push_back((curve.position->linear_motion(t[i], side).position - samples.positions()[i]).norm());
    }
    DistanceStatistics distance = distance_statistics(std::move(distances));
    if (distance.count > 0) distance.largest_at = kept[distance.largest_at];
    return distance;
  });
}

std::vector<std::string> labels_of(std::span<const Reduction> reductions) {
  std::vector<Method> methods;
  for (const Reduction& reduction : reductions) methods.push_back(reduction.method);
  return labels_of(methods);
}

std::size_t smallest(std::span<const Reduction> reductions) {
  const auto size = [](const Reduction& reduction) { return reduction.samples.size(); };
  return static_cast<std::size_t>(std::ranges::min_element(reductions, {}, size) - reductions.begin());
}

}}  // namespace orispline
