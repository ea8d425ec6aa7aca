// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <orispline/mean/weighted.hpp>

// Whether a mean that is at rest is the only one. Proof: docs/notes/averaging.md.

namespace orispline { inline namespace ORISPLINE_ABI { namespace mean_of {

/// An angle up to π, with the sine and cosine of its half.
struct HalvedAngle {
  double angle, sine, cosine;

  explicit HalvedAngle(double whole) : angle(whole) { sin_cos(0.5 * whole, sine, cosine); }
};

/// By how much ½ d² to an orientation at the angle `apart` from the mean rises at least, beside what its slope at the
/// mean says, from there to any point that is `from` to `to` away.
[[nodiscard]] inline double least_rise(const HalvedAngle& apart, const HalvedAngle& from, double to) {
  using std::numbers::pi;
  const double cosine = from.cosine * apart.cosine, sine = std::sqrt(1.0 - cosine * cosine);
  const double product = from.sine * apart.sine;
  const double third = 2.0 * atan2_of(sine, cosine);  // side of a triangle whose two others are at right angles
  const double slope = from.angle * apart.angle - 2.0 * third * product / sine;
  const double end = cosine < product ? -cosine / product : -1.0;
  const double rise = 0.5 * (third * third - apart.angle * apart.angle) + std::min(slope, slope * end);
  const double beyond = 2.0 * pi - to;  // the other way round
  return to + apart.angle > pi ? std::min(rise, 0.5 * beyond * beyond - 2.0 * pi * apart.angle) : rise;
}

/// Whether it is proved that no other point is as good as this mean.
[[nodiscard]] inline bool is_only_mean(const Weighted<Eigen::Quaterniond>& given, const Eigen::Quaterniond& mean) {
  using std::numbers::pi;
  constexpr double longest = 0.25, shortest = 0.01;  // steps [rad]
  constexpr double margin = 1e-9;                    // far above what rounding and the residual do
  std::vector<HalvedAngle> angles;
  angles.reserve(given.size());
  double moment = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    angles.emplace_back(way_to(mean, given.points[k]).length);
    moment += given.weights[k] * angles.back().angle;
    largest = std::max(largest, angles.back().angle);
  }
  const double last = std::min(pi, 2.0 * moment);
  double step = longest;
  for (double from = pi - largest; from < last;) {
    const HalvedAngle here(from);
    const double to = std::min(from + step, last);
    double rise = 0.0;
    for (std::size_t k = 0; k < given.size(); ++k) rise += given.weights[k] * least_rise(angles[k], here, to);
    if (rise > margin) from = to, step = std::min(longest, 2.0 * step);
    else if ((step *= 0.25) < shortest) return false;
  }
  return true;
}

}}}  // namespace orispline::mean_of
