// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothed_band.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <orispline/base/formatted.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t sixths = band_columns.size();
static_assert(NodeSigmas::within + 1 == sixths);

/// The probability that a normal vector of three has a length below r standard deviations: the series of the incomplete
/// gamma function of 3/2. Source: Abramowitz and Stegun, 6.5.29.
double probability_within(double r) {
  constexpr double gamma_of_5_halves = 1.3293403881791370;
  const double x = 0.5 * r * r;
  double sum = 0.0, term = 1.0;
  for (int n = 1; term > 1e-17 * sum; ++n) {
    sum += term;
    term *= x / (n + 1.5);
  }
  return x * std::sqrt(x) * elementary::exponential(-x) / gamma_of_5_halves * sum;
}

/// The length below which such a vector is with that probability.
double length_within(double share) {
  double low = 0.0, high = 10.0;  // the probability of which differs from 1 by less than rounding does
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (probability_within(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The polynomial of degree six through values at 0, 1, …, 6, at a place x between. Source: Lagrange.
double through_sixths(const std::array<double, sixths>& values, double last, double x) {
  double sum = 0.0;
  for (std::size_t k = 0; k <= sixths; ++k) {
    double factor = k < sixths ? values[k] : last;
    for (std::size_t j = 0; j <= sixths; ++j)
      if (j != k) factor *= (x - static_cast<double>(j)) / (static_cast<double>(k) - static_cast<double>(j));
    sum += factor;
  }
  return sum;
}

/// The keys behind which a gap begins.
Expected<std::vector<bool>> ends_of(const Track& keys) {
  std::vector<bool> ends(keys.keys.size(), false);
  if (!are_in_stretches(keys.keys, keys.recipe.gap)) return ends;
  return stretches_between_gaps(keys.keys.times(), keys.recipe.gap).map([&](const std::vector<Stretch>& stretches) {
    for (const Stretch& stretch : stretches) ends[stretch.first + stretch.count - 1] = true;
    return ends;
  });
}

}  // namespace

void set_band(Track& keys, const NodeSigmas& sigmas) {
  for (std::size_t k = 0; k < sixths; ++k) {
    std::vector<double>& column = keys.settings[std::string(band_columns[k])];
    column.clear();
    for (std::size_t key = 0; key < sigmas.to_next.size(); ++key)
      column.push_back(k == 0 ? std::sqrt(sigmas.orientations[key].squaredNorm() / 3.0) : sigmas.to_next[key][k - 1]);
  }
}

bool SmoothedBand::is_of(const Track& keys, const Method& method) {
  return method.name == smoothed_method &&
         std::ranges::all_of(band_columns, [&](std::string_view name) { return keys.settings.contains(name); });
}

Expected<SmoothedBand> SmoothedBand::make(const Track& keys, double share) {
  if (!(share > 0.0 && share < 1.0))
    return failure(ErrorCode::bad_argument, formatted("the share of a band is {}, wanted between 0 and 1", share));
  SmoothedBand band;
  band.radius_ = length_within(share);
  band.times_.assign(keys.keys.times().begin(), keys.keys.times().end());
  band.variances_.resize(band.times_.size());
  for (std::size_t k = 0; k < sixths; ++k) {
    const std::vector<double>& column = keys.settings.find(band_columns[k])->second;
    for (std::size_t key = 0; key < column.size(); ++key) {
      if (!(column[key] >= 0.0) || !std::isfinite(column[key]))
        return failure(ErrorCode::bad_data,
                       formatted("{}: found {}, wanted a finite number of at least 0", band_columns[k], column[key]),
                       {.key = key});
      band.variances_[key][k] = column[key] * column[key];
    }
  }
  return ends_of(keys).map([&](std::vector<bool> ends) {
    band.ends_ = std::move(ends);
    return std::move(band);
  });
}

double SmoothedBand::operator()(double t) const noexcept {
  if (std::isnan(t)) return t;
  const auto behind = std::ranges::upper_bound(times_, t);
  const auto key = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, behind - times_.begin() - 1));
  double variance = variances_[key][0];
  if (t > times_[key] && key + 1 < times_.size()) {
    if (ends_[key]) return std::numeric_limits<double>::quiet_NaN();
    const double x = (t - times_[key]) / (times_[key + 1] - times_[key]);
    variance = through_sixths(variances_[key], variances_[key + 1][0], static_cast<double>(sixths) * x);
  }
  return radius_ * std::sqrt(std::max(0.0, variance));
}

}}  // namespace orispline
