// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <online/online_stream.hpp>
#include <orispline/online/track_sampler.hpp>

namespace orispline::testing_support {

using KeySettings = std::map<std::string, std::vector<double>, std::less<>>;

/// Samples with all that a pose has.
struct TrackSamples {
  std::vector<double> times, orientations, angular_velocities, angular_accelerations, angular_jerks, positions,
      velocities, accelerations;

  [[nodiscard]] std::size_t size() const { return times.size(); }
  /// Room for more samples behind these.
  [[nodiscard]] Samples<double> grow(std::size_t count, bool has_positions) {
    const auto more = [](std::vector<double>& list, std::size_t numbers) {
      list.resize(list.size() + numbers);
      return std::span(list).last(numbers);
    };
    more(times, count);
    Samples<double> room{.orientations = more(orientations, 4 * count),
                         .angular_velocities = more(angular_velocities, 3 * count),
                         .angular_accelerations = more(angular_accelerations, 3 * count),
                         .angular_jerks = more(angular_jerks, 3 * count)};
    if (!has_positions) return room;
    room.positions = more(positions, 3 * count);
    room.velocities = more(velocities, 3 * count);
    room.accelerations = more(accelerations, 3 * count);
    return room;
  }
  bool operator==(const TrackSamples&) const = default;
};

/// Takes the next samples behind those that are there.
[[nodiscard]] inline Expected<void> take(TrackSampler& sampler, TrackSamples& into, std::size_t count,
                                         bool has_positions) {
  const Samples<double> room = into.grow(count, has_positions);
  return sampler.take(room, std::span(into.times).last(count));
}

/// What sample() takes of the whole curve at the times of the grid that it covers.
[[nodiscard]] inline TrackSamples of_whole(const PoseCurve& curve, double start, double step, double parts = 1.0) {
  const Domain domain = curve.orientation.domain();
  const auto time = [&](std::size_t k) { return static_cast<double>(k) * step / parts + start; };
  std::vector<double> times;
  for (std::size_t k = 0; time(k) <= domain.end; ++k)
    if (time(k) >= domain.start) times.push_back(time(k));
  TrackSamples samples;
  const Samples<double> room = samples.grow(times.size(), curve.position.has_value());
  const auto sampled = sample<double>(curve, times, room);
  samples.times = times;
  return sampled ? samples : TrackSamples{};
}

/// Keys first … last - 1 of the data.
[[nodiscard]] inline KeyframeData part_of(const KeyframeData& data, std::size_t first, std::size_t last) {
  const auto part = [&](const auto& list) {
    using List = std::remove_cvref_t<decltype(list)>;
    return list.empty() ? List{}
                        : List(list.begin() + static_cast<std::ptrdiff_t>(first),
                               list.begin() + static_cast<std::ptrdiff_t>(last));
  };
  return {.times = part(data.times),
          .orientations = part(data.orientations),
          .positions = part(data.positions),
          .angular_velocities = part(data.angular_velocities),
          .angular_accelerations = part(data.angular_accelerations),
          .angular_jerks = part(data.angular_jerks),
          .inner_leaving = part(data.inner_leaving),
          .inner_arriving = part(data.inner_arriving)};
}

/// Feeds the keys in pieces of random length, puts the state away and back at random, takes samples in random portions.
[[nodiscard]] inline TrackSamples streamed(TrackSampler sampler, const KeyframeData& data, const KeySettings& settings,
                                           std::uint64_t seed) {
  Dice dice(seed);
  TrackSamples samples;
  const bool has_positions = !data.positions.empty();
  const auto count = data.times.size();
  for (std::size_t first = 0; first < count;) {
    const std::size_t last =
        std::min(count, first + 1 + static_cast<std::size_t>(dice.between(0.0, 1.5) * 12.0 * dice()));
    KeySettings part;
    for (const auto& [name, values] : settings)
      part[name] = {values.begin() + static_cast<std::ptrdiff_t>(first),
                    values.begin() + static_cast<std::ptrdiff_t>(last)};
    if (auto taken = sampler.append(part_of(data, first, last), part); !taken) {
      ADD_FAILURE() << describe(taken.error());
      return samples;
    }
    if (dice() < 0.3) sampler = TrackSampler::from_state(sampler.state()).value();
    const double share = dice();
    const auto ready = static_cast<double>(sampler.ready());
    const auto wanted = static_cast<std::size_t>(share < 0.2 ? 0.0 : share > 0.5 ? ready : ready * share);
    if (auto taken = take(sampler, samples, wanted, has_positions); !taken) ADD_FAILURE() << describe(taken.error());
    if (dice() < 0.3) sampler = TrackSampler::from_state(sampler.state()).value();
    first = last;
  }
  if (auto done = sampler.finish(); !done) ADD_FAILURE() << describe(done.error());
  if (dice() < 0.5) sampler = TrackSampler::from_state(sampler.state()).value();
  const auto rest = static_cast<std::size_t>(sampler.ready());
  if (auto taken = take(sampler, samples, rest / 3, has_positions); !taken) ADD_FAILURE() << describe(taken.error());
  if (auto taken = take(sampler, samples, rest - rest / 3, has_positions); !taken)
    ADD_FAILURE() << describe(taken.error());
  EXPECT_EQ(sampler.ready(), 0u);
  return samples;
}

}  // namespace orispline::testing_support
