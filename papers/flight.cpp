// SPDX-License-Identifier: Apache-2.0
#include "papers/flight.hpp"

#include "papers/example_data.hpp"

namespace orispline::cli {

namespace {

Expected<Flight> flight(std::string name, std::span<const DataRow> truth, std::span<const DataRow> keys) {
  return Keyframes::make(key_data(keys)).map([&](const Keyframes& made) {
    Flight result{.name = std::move(name), .keys = made};
    for (const DataRow& row : truth) {
      result.times.push_back(row.t);
      result.orientations.push_back(quaternion_wxyz(row.qw, row.qx, row.qy, row.qz));
      result.truth.push_back({.orientation = result.orientations.back(), .angular_velocity = {row.wx, row.wy, row.wz}});
    }
    return result;
  });
}

/// What the recording has at one of its times, by the curve through it where it has no rate.
Motion motion_at(const ComparedData& data, std::size_t i, const AnyCurve& through) {
  const auto rates = data.samples.angular_velocities();
  Motion motion{.orientation = data.samples.orientations()[i]};
  const bool has_rate = !rates.empty() && !is_free(rates[i]);
  motion.angular_velocity = has_rate ? rates[i] : through.motion(data.samples.times()[i]).angular_velocity;
  return motion;
}

}  // namespace

Expected<Flight> first_turn() {
  constexpr std::size_t first = 260, step = 240, count = 5;  // samples of 0.01 s
  const auto rows = flight_truth_rows().subspan(first, (count - 1) * step + 1);
  std::vector<DataRow> keys;
  for (std::size_t i = 0; i < count; ++i) keys.push_back(rows[i * step]);
  return flight("five keys of the flight's first turn", rows, keys);
}

Expected<Flight> whole_flight() { return flight("all 38 keys of the flight", flight_truth_rows(), flight_key_rows()); }

Expected<Flight> flight_of(const ComparedData& data, std::string name) {
  return make_curve("auto", data.samples).map([&](const AnyCurve& through) {
    const Keyframes& keys = data.key_sets.front().track.keys;
    Flight result{.name = std::move(name), .keys = keys};
    for (std::size_t i = 0; i < data.times.size(); ++i) {
      if (data.times[i] < keys.times().front() || data.times[i] > keys.times().back()) continue;
      result.times.push_back(data.times[i]);
      result.truth.push_back(motion_at(data, i, through));
      result.orientations.push_back(result.truth.back().orientation);
    }
    return result;
  });
}

Keyframes truth_of(const Flight& flight) {
  return Keyframes::make({.times = flight.times, .orientations = flight.orientations}).value_or(Keyframes());
}

}  // namespace orispline::cli
