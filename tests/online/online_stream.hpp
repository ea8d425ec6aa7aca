// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/families/registry.hpp>
#include <orispline/online/online_curve.hpp>
#include <support/tracks.hpp>

namespace orispline::testing_support {

/// A posed walk as sensors send it: norms that are not quite 1, signs at random.
[[nodiscard]] inline KeyframeData raw_walk(std::uint64_t seed, std::size_t count, Spacing spacing = Spacing::uneven) {
  KeyframeData data = posed_walk(seed, count, spacing, 1.5);
  Dice dice(seed + 2);
  for (Eigen::Quaterniond& q : data.orientations)
    q.coeffs() *= (dice() < 0.5 ? -1.0 : 1.0) * dice.between(0.9995, 1.0005);
  return data;
}

/// Which keys a stream has made final: how a method says that it uses them.
struct FinalKeys {
  KeyUse use;
  std::size_t look_ahead;

  FinalKeys(std::string_view method, const OnlineCurve& curve)
      : use(find_family(method).value()->key_use), look_ahead(curve.look_ahead()) {}
  /// How many segments are final when so many keys have come; the first ones feel the start.
  [[nodiscard]] std::size_t segments(std::size_t keys) const {
    if (keys < std::max(2 * look_ahead + 1, use.keys_for(1))) return 0;
    return (keys - 1 - use.first - look_ahead) / use.stride;
  }
  /// The key where that segment begins.
  [[nodiscard]] std::size_t start(std::size_t segment) const { return use.first + use.stride * segment; }
};

/// Key i of the data.
[[nodiscard]] inline StreamKey key_of(const KeyframeData& data, std::size_t i) {
  const auto at = [i](const auto& list) { return list.empty() ? std::nullopt : std::optional(list[i]); };
  return {.time = data.times[i],
          .orientation = data.orientations[i],
          .position = at(data.positions),
          .angular_velocity = at(data.angular_velocities),
          .angular_acceleration = at(data.angular_accelerations),
          .angular_jerk = at(data.angular_jerks),
          .inner_leaving = at(data.inner_leaving),
          .inner_arriving = at(data.inner_arriving)};
}

/// Appends keys first … last - 1 of the data.
[[nodiscard]] inline Expected<void> append(OnlineCurve& curve, const KeyframeData& data, std::size_t first,
                                           std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    auto taken = data.positions.empty() ? curve.append(data.times[i], data.orientations[i])
                                        : curve.append(data.times[i], data.orientations[i], data.positions[i]);
    if (!taken) return taken;
  }
  return {};
}

}  // namespace orispline::testing_support
