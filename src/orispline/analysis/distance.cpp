// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/distance.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/analysis/sampled.hpp>
#include <orispline/base/expect.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double percentile(std::span<const double> rising, double part) {
  const double at = part * static_cast<double>(rising.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, rising.size() - 1);
  return std::lerp(rising[below], rising[above], at - static_cast<double>(below));
}

}  // namespace

DistanceStatistics distance_statistics(std::vector<double> distances, std::size_t first) {
  const auto is_absent = [](double distance) { return std::isnan(distance); };
  const auto any = std::ranges::find_if_not(distances, is_absent);
  if (any == distances.end()) return {};
  auto largest = any;
  for (auto distance = any; distance != distances.end(); ++distance)
    if (*distance > *largest) largest = distance;
  DistanceStatistics statistics{.largest = *largest,
                                .largest_at = first + static_cast<std::size_t>(largest - distances.begin())};
  std::erase_if(distances, is_absent);
  statistics.count = distances.size();
  double sum = 0.0, sum_of_squares = 0.0;
  for (const double distance : distances) {
    sum += distance;
    sum_of_squares += distance * distance;
  }
  const auto count = static_cast<double>(statistics.count);
  statistics.mean = sum / count;
  statistics.rms = std::sqrt(sum_of_squares / count);
  std::ranges::sort(distances);
  statistics.median = percentile(distances, 0.50);
  statistics.percentile_95 = percentile(distances, 0.95);
  statistics.percentile_99 = percentile(distances, 0.99);
  return statistics;
}

DistanceStatistics distance_to_reference(const AnyCurve& curve, OrientationSeries reference) {
  return distance_to_reference(curve, reference, curve.domain());
}

DistanceStatistics distance_to_reference(const AnyCurve& curve, OrientationSeries reference, Domain stretch) {
  ORISPLINE_EXPECT(reference.times.size() == reference.orientations.size());
  const auto [first, count] = times_within(reference.times, stretch);
  const auto samples = sampled(curve, reference.times.subspan(first, count), Sampled::orientations);
  std::vector<double> distances(count);
  for (std::size_t i = 0; i < count; ++i)
    distances[i] = angular_distance(samples.orientations[i], reference.orientations[first + i]);
  return distance_statistics(std::move(distances), first);
}

DistanceStatistics rate_statistics(std::span<const Eigen::Vector3d> found, std::span<const Eigen::Vector3d> logged,
                                   std::size_t first) {
  std::vector<double> errors;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (is_free(logged[i]) || found[i].hasNaN()) continue;  // not logged, or in a gap
    errors.push_back((found[i] - logged[i]).norm());
    places.push_back(first + i);
  }
  DistanceStatistics statistics = distance_statistics(std::move(errors));
  if (!places.empty()) statistics.largest_at = places[statistics.largest_at];
  return statistics;
}

DistanceStatistics rate_error(const AnyCurve& curve, RateSeries logged) {
  ORISPLINE_EXPECT(logged.times.size() == logged.angular_velocities.size());
  const auto [first, count] = times_within(logged.times, curve.domain());
  const auto samples = sampled(curve, logged.times.subspan(first, count), Sampled::orientations_and_rates);
  return rate_statistics(samples.angular_velocities, logged.angular_velocities.subspan(first, count), first);
}

}}  // namespace orispline
