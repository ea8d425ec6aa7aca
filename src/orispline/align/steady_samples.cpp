// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/steady_samples.hpp>

#include <algorithm>
#include <cmath>
#include <span>

#include <orispline/math/geodesic.hpp>
#include <orispline/math/median.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t reach = 3;        // places before and behind
constexpr std::size_t seen_beside = 5;  // distances on each side that tell what is usual
constexpr double farther_than_usual = 6.0;

/// `deviation(before, i, after, part)`: how far sample i is from the share of the way between two others.
template <class Deviation>
double distance_from_neighbours(std::span<const double> t, std::size_t i, Deviation deviation) {
  std::vector<double> distances;
  for (std::size_t k = 1; k <= reach && k <= i && i + k < t.size(); ++k)
    distances.push_back(deviation(i - k, i, i + k, (t[i] - t[i - k]) / (t[i + k] - t[i - k])));
  return median(std::move(distances));
}

double usual_beside(std::span<const double> distances, std::size_t i) {
  std::vector<double> beside;
  const std::size_t first = i < seen_beside ? 0 : i - seen_beside;
  for (std::size_t k = first; k < std::min(i + seen_beside + 1, distances.size()); ++k)
    if (k != i) beside.push_back(distances[k]);
  return median(std::move(beside));
}

template <class Deviation>
std::vector<bool> are_steady(std::span<const double> times, Deviation deviation) {
  std::vector<double> distances(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) distances[i] = distance_from_neighbours(times, i, deviation);
  const double usual = median(distances);
  std::vector<bool> steady(times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    steady[i] = distances[i] <= farther_than_usual * std::max(usual, usual_beside(distances, i));
  return steady;
}

}  // namespace

std::vector<std::size_t> steady_samples(const Keyframes& keys) {
  const auto q = keys.orientations();
  const std::vector<bool> are = are_steady(keys.times(), [q](std::size_t a, std::size_t i, std::size_t b, double part) {
    return angular_distance(on_geodesic(q[a], q[b], part), q[i]);
  });
  std::vector<std::size_t> steady;
  for (std::size_t i = 0; i < are.size(); ++i)
    if (are[i]) steady.push_back(i);
  return steady;
}

CountedRates steady_rates(const GyroRates& gyro) {
  const auto& w = gyro.rates;
  return are_steady(gyro.times, [&w](std::size_t a, std::size_t i, std::size_t b, double part) {
    return (w[i] - (1.0 - part) * w[a] - part * w[b]).norm();
  });
}

}}  // namespace orispline
