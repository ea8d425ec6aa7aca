// SPDX-License-Identifier: Apache-2.0
#include "papers/flight.hpp"

#include "papers/example_data.hpp"

namespace orispline::cli {

namespace {

Expected<Flight> flight(std::span<const DataRow> truth, std::span<const DataRow> keys) {
  return Keyframes::make(key_data(keys)).map([&](Keyframes made) {
    Flight result{.times = {}, .truth = {}, .orientations = {}, .keys = std::move(made)};
    for (const DataRow& row : truth) {
      result.times.push_back(row.t);
      result.orientations.push_back(quaternion_wxyz(row.qw, row.qx, row.qy, row.qz));
      result.truth.push_back({.orientation = result.orientations.back(), .angular_velocity = {row.wx, row.wy, row.wz}});
    }
    return result;
  });
}

}  // namespace

Expected<Flight> first_turn() {
  constexpr std::size_t first = 260, step = 240, count = 5;  // samples of 0.01 s
  const auto rows = flight_truth_rows().subspan(first, (count - 1) * step + 1);
  std::vector<DataRow> keys;
  for (std::size_t i = 0; i < count; ++i) keys.push_back(rows[i * step]);
  return flight(rows, keys);
}

Expected<Flight> whole_flight() { return flight(flight_truth_rows(), flight_key_rows()); }

Keyframes truth_of(const Flight& flight) {
  return Keyframes::make({.times = flight.times, .orientations = flight.orientations}).value_or(Keyframes());
}

}  // namespace orispline::cli
