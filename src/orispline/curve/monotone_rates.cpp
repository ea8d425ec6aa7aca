// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/monotone_rates.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Eigen::Vector3d;

Vector3d rate_between(const Vector3d& before, double time_before, const Vector3d& after, double time_after) {
  const double a = before.norm(), b = after.norm();
  if (!(a > 0.0 && b > 0.0)) return Vector3d::Zero();
  const double speed = harmonic_speed(a / time_before, time_before, b / time_after, time_after);
  return 0.5 * speed * (before / a + after / b);
}

/// By the increment at the end and the one next to it. Source: SciPy's PchipInterpolator, along the increment.
Vector3d rate_at_end(const Vector3d& increment, double time, const Vector3d& next, double time_next) {
  const double size = increment.norm();
  if (!(size > 0.0)) return Vector3d::Zero();
  const Vector3d axis = increment / size;
  const double mean = size / time, beside = axis.dot(next) / time_next;
  const double of_parabola = ((2.0 * time + time_next) * mean - time * beside) / (time + time_next);
  return std::clamp(of_parabola, 0.0, 3.0 * mean) * axis;
}

}  // namespace

double harmonic_speed(double before, double time_before, double after, double time_after) noexcept {
  const double weight_before = 2.0 * time_after + time_before, weight_after = time_after + 2.0 * time_before;
  return (weight_before + weight_after) / (weight_before / before + weight_after / after);
}

std::vector<Vector3d> monotone_rates(std::span<const Vector3d> increments, std::span<const double> steps,
                                     bool is_loop) {
  const std::size_t last = increments.size() - 1;
  const auto between = [&](std::size_t i, std::size_t k) {
    return rate_between(increments[i], steps[i], increments[k], steps[k]);
  };
  const auto at_end = [&](std::size_t i, std::size_t next) -> Vector3d {
    if (last == 0) return increments[0] / steps[0];
    return rate_at_end(increments[i], steps[i], increments[next], steps[next]);
  };
  std::vector<Vector3d> rates{is_loop ? between(last, 0) : at_end(0, 1)};
  rates.reserve(increments.size() + 1);
  for (std::size_t i = 0; i < last; ++i) rates.push_back(between(i, i + 1));
  rates.push_back(is_loop ? rates.front() : at_end(last, last - 1));
  return rates;
}

}}  // namespace orispline
