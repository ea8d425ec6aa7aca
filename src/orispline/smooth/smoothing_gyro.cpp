// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_gyro.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/rate_comparison.hpp>
#include <orispline/math/median.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double fault_threshold = 20.0;   // of the difference, in its medians: the fit's own errors come in bursts
constexpr double unit_threshold = 20.0;    // between right rates and those in degrees, 57 times as large
constexpr double noise_threshold = 10.0;   // of the gyro's rates, in its noise: below it tells nothing
constexpr double against_threshold = 1.5;  // of independent rates the difference is √2 times one of them at most

using Vectors = std::vector<Eigen::Vector3d>;

Eigen::Vector3d median_of_axes(const Vectors& vectors) {
  Eigen::Vector3d medians;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& v : vectors) values.push_back(v[axis]);
    medians[axis] = median(std::move(values));
  }
  return medians;
}

/// Root of the mean square about the mean.
double spread(const Vectors& vectors) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vectors) mean += v / static_cast<double>(vectors.size());
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vectors) sum += (v - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

/// Rates of the fit, of the gyro, and their differences, at the samples of all stretches.
struct Rates {
  std::vector<std::size_t> samples;
  std::vector<Eigen::Quaterniond> orientations;
  Vectors fitted, measured, differences;
};

Rates rates_of(const StretchFits& fits, const Keyframes& recording, const std::vector<Stretch>& stretches) {
  Rates rates;
  for (std::size_t k = 0; k < stretches.size(); ++k)
    for (std::size_t i = 0; i < stretches[k].count; ++i) {
      rates.samples.push_back(stretches[k].first + i);
      rates.orientations.push_back(fits.fits[k].nodes.orientations[i]);
      rates.fitted.push_back(fits.fits[k].nodes.angular_velocities[i]);
      rates.measured.push_back(recording.angular_velocities()[rates.samples.back()]);
      rates.differences.push_back(rates.measured.back() - rates.fitted.back());
    }
  return rates;
}

std::vector<std::size_t> faults_in(const Rates& rates, const std::vector<Stretch>& stretches) {
  const Eigen::Vector3d bias = median_of_axes(rates.differences);
  std::vector<double> all;
  for (const Eigen::Vector3d& d : rates.differences) all.push_back((d - bias).norm());
  std::vector<std::vector<double>> lengths;
  auto next = all.begin();
  for (const Stretch& stretch : stretches) {
    const auto end = next + static_cast<std::ptrdiff_t>(stretch.count);
    lengths.emplace_back(next, end);
    next = end;
  }
  return far_samples(lengths, stretches, fault_threshold * std::max(least_noise, median(std::move(all)))).single;
}

Rates without(const Rates& rates, const std::vector<std::size_t>& faults) {
  Rates kept;
  for (std::size_t i = 0; i < rates.samples.size(); ++i) {
    if (std::ranges::binary_search(faults, rates.samples[i])) continue;
    kept.orientations.push_back(rates.orientations[i]);
    kept.fitted.push_back(rates.fitted[i]);
    kept.measured.push_back(rates.measured[i]);
    kept.differences.push_back(rates.differences[i]);
  }
  return kept;
}

}  // namespace

Expected<std::vector<std::size_t>> gyro_faults(const StretchFits& fits, const Keyframes& recording,
                                               const std::vector<Stretch>& stretches) {
  const Rates rates = rates_of(fits, recording, stretches);
  std::vector<std::size_t> faults = faults_in(rates, stretches);
  const Rates kept = without(rates, faults);
  const double fitted = spread(kept.fitted), measured = spread(kept.measured), difference = spread(kept.differences);
  const RateComparison comparison{kept.orientations, kept.measured, kept.fitted, RateComparison::Bias::constant};
  if (const auto meaning = comparison.better_meaning())
    return failure(ErrorCode::bad_data, formatted("the gyro's rates contradict the orientations: they vary by {:.3g} "
                                                  "rad/s, those of the orientations by {:.3g} rad/s, the difference by "
                                                  "{:.3g} rad/s; {}",
                                                  measured, fitted, difference, meaning->cure));
  const double noise = local_noise(recording.times(), recording.angular_velocities());
  if (measured > unit_threshold * fitted && measured > noise_threshold * noise)
    return failure(ErrorCode::bad_data, formatted("the gyro's rates vary by {:.3g} rad/s, those of the orientations by "
                                                  "{:.3g} rad/s, wanted a gyro in rad/s",
                                                  measured, fitted));
  if (difference > against_threshold * std::max(fitted, measured))
    return failure(
        ErrorCode::bad_data,
        formatted("the gyro turns against the orientations: their rates vary by {:.3g} and {:.3g} rad/s, the "
                  "difference by {:.3g} rad/s, wanted rates of the body in its own frame",
                  measured, fitted, difference));
  return faults;
}

}}  // namespace orispline
