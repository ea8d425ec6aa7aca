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

/// How far a sample is from the middle one of the geodesics past it [rad]; 0 where there are none.
double distance_from_neighbours(const Keyframes& keys, std::size_t i) {
  const auto t = keys.times();
  const auto q = keys.orientations();
  std::vector<double> distances;
  for (std::size_t k = 1; k <= reach && k <= i && i + k < keys.size(); ++k) {
    const double part = (t[i] - t[i - k]) / (t[i + k] - t[i - k]);
    distances.push_back(angular_distance(on_geodesic(q[i - k], q[i + k], part), q[i]));
  }
  return median(std::move(distances));
}

double usual_beside(std::span<const double> distances, std::size_t i) {
  std::vector<double> beside;
  const std::size_t first = i < seen_beside ? 0 : i - seen_beside;
  for (std::size_t k = first; k < std::min(i + seen_beside + 1, distances.size()); ++k)
    if (k != i) beside.push_back(distances[k]);
  return median(std::move(beside));
}

}  // namespace

std::vector<std::size_t> steady_samples(const Keyframes& keys) {
  std::vector<double> distances(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) distances[i] = distance_from_neighbours(keys, i);
  const double usual = median(distances);
  std::vector<std::size_t> steady;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (distances[i] <= farther_than_usual * std::max(usual, usual_beside(distances, i))) steady.push_back(i);
  return steady;
}

}}  // namespace orispline
