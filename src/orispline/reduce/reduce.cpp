// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/reduce.hpp>

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include <orispline/base/parallel.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/families/slerp.hpp>
#include <orispline/reduce/fewest_geodesics.hpp>
#include <orispline/reduce/key_refit.hpp>
#include <orispline/reduce/key_selection.hpp>

namespace orispline {
namespace {

constexpr double smallest_tolerance = 1e-12;  // [rad]: far above the rounding of orientations

Expected<LocalMethod> local_method(std::string_view name) {
  const auto family = find_family(name);
  if (!family) return tl::unexpected(family.error());
  const FamilyInfo& info = **family;
  if (info.support_keys == all_keys || !info.interpolates)
    return failure(ErrorCode::bad_argument,
                   fmt::format("{}: found a method {}, wanted a local one through its keys, such as auto", name,
                               info.interpolates ? "that depends on all keys" : "that passes near its keys"));
  return LocalMethod{info.name, static_cast<std::size_t>(info.support_keys + 1) / 2};
}

/// [m]: far above the rounding of positions; 0 where there are none.
double smallest_position_tolerance(const Keyframes& recording) {
  double largest = 0.0;
  for (const Eigen::Vector3d& position : recording.positions()) largest = std::max(largest, position.norm());
  return 64.0 * std::numeric_limits<double>::epsilon() * largest;
}

Expected<void> check(const Keyframes& recording, const Tolerance& tolerance) {
  if (!(tolerance.angle >= smallest_tolerance))
    return failure(ErrorCode::bad_argument, fmt::format("the tolerance is {:.6g} rad, wanted {:.0e} rad at least: the "
                                                        "rounding of orientations is not much smaller",
                                                        tolerance.angle, smallest_tolerance));
  if (!(tolerance.position > 0.0))
    return failure(ErrorCode::bad_argument,
                   fmt::format("the tolerance of positions is {:.6g} m, wanted more than 0", tolerance.position));
  if (const double smallest = smallest_position_tolerance(recording); !(tolerance.position >= smallest))
    return failure(
        ErrorCode::bad_argument,
        fmt::format("the tolerance of positions is {:.6g} m, wanted {:.1e} m at least: the rounding of these "
                    "positions is not much smaller",
                    tolerance.position, smallest));
  if (recording.size() < 2)
    return failure(ErrorCode::bad_data, "found 1 sample, wanted 2 at least to keep the fewest that suffice");
  return {};
}

Expected<KeySet> chosen_keys(const LocalMethod& method, const ToleranceCheck& recording) {
  if (method.name == families::Slerp::info.name) return recording.keys_at(fewest_geodesics(recording));
  return selected_keys(method, recording);
}

/// With the deviation of what was found, measured anew.
Expected<Reduction> certified(const LocalMethod& method, const ToleranceCheck& recording, KeySet found) {
  auto keys = recording.keyframes(found);
  if (!keys) return tl::unexpected(std::move(keys.error()));
  const auto deviation = recording.deviation(method.name, *keys);
  if (!deviation) return tl::unexpected(deviation.error());
  const Tolerance tolerance = recording.tolerance();
  const auto missed = [&](double distance, double wanted, std::string_view unit) {
    return failure(ErrorCode::bad_argument,
                   fmt::format("{}: the curve is {:.6g} {} from a sample, wanted {:.6g} {}: the tolerance is below "
                               "rounding",
                               method.name, distance, unit, wanted, unit));
  };
  if (deviation->angle > tolerance.angle) return missed(deviation->angle, tolerance.angle, "rad");
  if (deviation->position.value_or(0.0) > tolerance.position)
    return missed(*deviation->position, tolerance.position, "m");
  return Reduction{method.name, std::move(found.samples), std::move(*keys), *deviation};
}

}  // namespace

Expected<Reduction> reduce(std::string_view method, const Keyframes& samples, const ReduceOptions& options) {
  const auto local = local_method(method);
  if (!local) return tl::unexpected(local.error());
  if (const auto checked = check(samples, options.tolerance); !checked) return tl::unexpected(checked.error());
  const ToleranceCheck recording(samples, options.tolerance);
  return chosen_keys(*local, recording)
      .and_then([&](KeySet keys) -> Expected<KeySet> {
        if (options.values == KeyValues::sampled) return keys;
        return with_keys_refitted(*local, recording, std::move(keys));
      })
      .and_then([&](KeySet keys) { return certified(*local, recording, std::move(keys)); });
}

std::vector<Expected<std::vector<Reduction>>> reduce_tracks(std::span<const std::string_view> methods,
                                                            std::span<const Keyframes> tracks,
                                                            const ReduceOptions& options, unsigned threads) {
  std::vector<std::optional<Expected<Reduction>>> found(tracks.size() * methods.size());
  parallel_for(found.size(), threads, [&](std::size_t i) {
    found[i] = reduce(methods[i % methods.size()], tracks[i / methods.size()], options);
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

Expected<std::vector<Reduction>> reduce_by_each(std::span<const std::string_view> methods, const Keyframes& recording,
                                                const ReduceOptions& options) {
  const auto threads = static_cast<unsigned>(methods.size());
  return std::move(reduce_tracks(methods, std::span(&recording, 1), options, threads).front());
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
  return make_curve(reduction.method, reduction.keys).map([&](const AnyCurve& curve) {
    DistanceStatistics distance = distance_to_reference(curve, {times, orientations});
    if (distance.count > 0) distance.largest_at = kept[distance.largest_at];
    return distance;
  });
}

std::size_t smallest(std::span<const Reduction> reductions) {
  const auto size = [](const Reduction& reduction) { return reduction.samples.size(); };
  return static_cast<std::size_t>(std::ranges::min_element(reductions, {}, size) - reductions.begin());
}

}  // namespace orispline
