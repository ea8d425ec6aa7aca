// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_noise.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/eigensystem.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_element.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double medians_that_count = 3.0, lopsided = 4.0;  // lengths, variances

/// `deviation(i, a)`: how far value i is from the share a of the way between its neighbours. Values that lie there to
/// rounding, as while a recording rests or repeats itself, tell nothing of the noise: 0.
template <class Deviation>
std::vector<double> noises_from(std::span<const double> times, double least, Deviation deviation) {
  std::vector<double> scaled;
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    const double a = (times[i] - times[i - 1]) / (times[i + 1] - times[i - 1]);
    const double distance = deviation(i, a);
    scaled.push_back(distance > least ? distance / std::sqrt(1.0 + a * a + (1.0 - a) * (1.0 - a)) : 0.0);
  }
  return scaled;
}

double usual(std::vector<double> noises) {
  std::erase(noises, 0.0);
  return median(std::move(noises)) / median_length;
}

}  // namespace

double lopsided_deviation(std::span<const Eigen::Vector3d> vectors) {
  std::vector<double> lengths;
  for (const Eigen::Vector3d& v : vectors) lengths.push_back(v.norm());
  const double bound = medians_that_count * median(std::move(lengths));
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double count = 0.0;
  for (const Eigen::Vector3d& v : vectors) {
    if (!(v.norm() <= bound)) continue;
    moments += v * v.transpose();
    count += 1.0;
  }
  if (count == 0.0) return 0.0;
  const Eigen::Vector3d variances = eigensystem<3>(moments / count).values;
  return variances[2] > lopsided * std::max(0.0, variances[0]) ? std::sqrt(variances[2]) : 0.0;
}

std::vector<double> local_noises(std::span<const double> times, std::span<const Eigen::Quaterniond> orientations) {
  return noises_from(times, least_noise, [orientations](std::size_t i, double a) {
    const Eigen::Vector3d before = shortest_increment(orientations[i - 1], orientations[i]),
                          after = shortest_increment(orientations[i], orientations[i + 1]);
    return ((1.0 - a) * before - a * after).norm();
  });
}

double local_noise(std::span<const double> times, std::span<const Eigen::Quaterniond> orientations) {
  return usual(local_noises(times, orientations));
}

double local_noise(std::span<const double> times, std::span<const Eigen::Vector3d> vectors, double least) {
  return usual(noises_from(times, least, [vectors](std::size_t i, double a) {
    return (vectors[i] - (1.0 - a) * vectors[i - 1] - a * vectors[i + 1]).norm();
  }));
}

}}  // namespace orispline
