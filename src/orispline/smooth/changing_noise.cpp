// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/changing_noise.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/median.hpp>
#include <orispline/math/number.hpp>
#include <orispline/smooth/smoothing_noise.hpp>
#include <orispline/smooth/smoothing_outliers.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t shortest_stretch = 30;  // differences: a strike is shorter
constexpr double least_change = 2.0;          // of σ
constexpr double sure_change = 40.0;          // of a split, as the square of a normal variable
constexpr double clear_gain = 4.0;            // of a split, as such a variable, not squared
constexpr double rounding_share = 0.1;        // of the usual distance, below which a distance tells nothing more

/// Logarithms of the noise between neighbours, and the sample in the middle of each.
struct LogNoises {
  std::vector<std::size_t> samples;
  std::vector<double> values;
  std::vector<double> sums{0.0};

  explicit LogNoises(const Keyframes& recording) {
    const std::vector<double> all = local_noises(recording.times(), recording.orientations());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!(all[i] > 0.0)) continue;
      samples.push_back(i + 1);
      values.push_back(elementary::natural_logarithm(all[i]));
      sums.push_back(sums.back() + values.back());
    }
  }

  [[nodiscard]] double mean(std::size_t first, std::size_t last) const {
    return (sums[last] - sums[first]) / static_cast<double>(last - first);
  }
  [[nodiscard]] double median_of(std::size_t first, std::size_t last) const {
    const auto at = [this](std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
    return median({at(first), at(last)});
  }
};

/// Successive ones of the logarithms.
struct Part {
  std::size_t first, last;
};

/// Splits a part where its mean changes most, and the halves again, as long as the change is sure and by enough.
void split(const LogNoises& noises, const Part& part, double variance, std::vector<Part>& parts) {
  std::size_t best = 0;
  double most = 0.0;
  for (std::size_t k = part.first + shortest_stretch; k + shortest_stretch <= part.last; ++k) {
    const double change = noises.mean(k, part.last) - noises.mean(part.first, k);
    const auto before = static_cast<double>(k - part.first), after = static_cast<double>(part.last - k);
    const double gain = change * change * before * after / (before + after);
    if (gain > most) {
      most = gain;
      best = k;
    }
  }
  const bool sure = most > sure_change * variance;
  if (!sure) return parts.push_back(part);
  split(noises, {part.first, best}, variance, parts);
  split(noises, {best, part.last}, variance, parts);
}

/// Joins neighbours between which the noise does not change by enough.
std::vector<Part> joined(const LogNoises& noises, const std::vector<Part>& parts) {
  const double least = elementary::natural_logarithm(least_change);
  std::vector<Part> all;
  for (const Part& part : parts) {
    const bool same = !all.empty() && std::abs(noises.median_of(all.back().first, all.back().last) -
                                               noises.median_of(part.first, part.last)) < least;
    if (same) all.back().last = part.last;
    else all.push_back(part);
  }
  return all;
}

/// Of one difference of three normal variables: that of the logarithm of a chi variable with 3 degrees of freedom,
/// 0.23, times two, for neighbours share samples.
constexpr double variance_of_logarithm = 0.46;

std::vector<double> left_out_distances(const PredictedSamples& seen) {
  std::vector<double> all;
  for (const auto& part : left_out_errors(seen.problems, seen.fits, seen.objective))
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<double> changing_noise(const Keyframes& recording) {
  const LogNoises noises(recording);
  if (noises.values.size() < 2 * shortest_stretch) return {};
  std::vector<Part> parts;
  split(noises, {0, noises.values.size()}, variance_of_logarithm, parts);
  parts = joined(noises, parts);
  if (parts.size() < 2) return {};
  std::vector<double> sigmas(recording.size());
  std::size_t sample = 0;
  for (const Part& part : parts) {
    const double sigma =
        std::max(least_noise, elementary::exponential(noises.median_of(part.first, part.last)) / median_length);
    const std::size_t end = part.last == noises.values.size() ? sigmas.size() : noises.samples[part.last];
    for (; sample < end; ++sample) sigmas[sample] = sigma;
  }
  return sigmas;
}

bool predicts_better(const PredictedSamples& before, const PredictedSamples& after) {
  const std::vector<double> one = left_out_distances(before), other = left_out_distances(after);
  const double least = rounding_share * std::min(median(one), median(other));
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (!(one[i] > 0.0) || !(other[i] > 0.0)) continue;
    const double gain = elementary::natural_logarithm((one[i] + least) / (other[i] + least));
    sum += gain;
    squares += gain * gain;
  }
  return sum > clear_gain * std::sqrt(squares);
}

}}  // namespace orispline
