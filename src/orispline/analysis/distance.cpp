// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/distance.hpp>

#include <cmath>

namespace orispline {

DistanceStatistics distance_to_reference(const AnyCurve& curve, OrientationSeries reference) {
  ORISPLINE_EXPECT(reference.times.size() == reference.orientations.size());
  DistanceStatistics statistics;
  double sum = 0.0, sum_of_squares = 0.0;
  for (std::size_t i = 0; i < reference.times.size(); ++i) {
    if (!curve.domain().contains(reference.times[i])) continue;
    const double distance = angular_distance(curve(reference.times[i]), reference.orientations[i]);
    if (++statistics.count == 1 || distance > statistics.largest) {
      statistics.largest = distance;
      statistics.largest_at = i;
    }
    sum += distance;
    sum_of_squares += distance * distance;
  }
  if (statistics.count == 0) return statistics;
  const auto count = static_cast<double>(statistics.count);
  statistics.mean = sum / count;
  statistics.rms = std::sqrt(sum_of_squares / count);
  return statistics;
}

}  // namespace orispline
