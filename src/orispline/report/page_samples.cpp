// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_samples.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <orispline/math/slerp.hpp>

namespace orispline::report {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

void append(PageSamples& samples, const PoseCurve& curve, double t, Side side) {
  const Motion motion = curve.orientation.motion(t, side);
  samples.path.times.push_back(t);
  samples.path.orientations.push_back(motion.orientation);
  samples.angular_velocities.push_back(motion.angular_velocity);
  samples.angular_accelerations.push_back(motion.angular_acceleration);
  samples.angular_jerks.push_back(motion.angular_jerk);
  if (curve.position) samples.positions.push_back(curve.position->travel(t, side).position);
}

/// The k-th of `steps` equal steps from a to b; exactly b at the last one.
double between(double a, double b, std::size_t k, std::size_t steps) {
  return std::lerp(a, b, static_cast<double>(k) / static_cast<double>(steps));
}

/// The time in the reference's interval that ends at `after`, by the shortest way.
Eigen::Quaterniond on_reference(const PagePath& reference, std::size_t after, double t) {
  const double start = reference.times[after - 1], step = reference.times[after] - start;
  const Eigen::Quaterniond& from = reference.orientations[after - 1];
  Eigen::Quaterniond to = reference.orientations[after];
  if (from.dot(to) < 0.0) to.coeffs() = -to.coeffs();
  return step > 0.0 ? slerp<double>(from, to, (t - start) / step) : to;
}

}  // namespace

PageKeys page_keys(const Keyframes& keys) {
  return {
      .path = {{keys.times().begin(), keys.times().end()}, {keys.orientations().begin(), keys.orientations().end()}},
      .positions = {keys.positions().begin(), keys.positions().end()}};
}

PageSamples sampled(const PoseCurve& curve, std::size_t count) {
  PageSamples samples;
  const Knots& knots = curve.orientation.knots();
  const Domain domain = curve.orientation.domain();
  const std::size_t segments = knots.segments();
  if (segments == 0) append(samples, curve, domain.start, Side::right);
  if (4 * segments > count) {
    for (std::size_t k = 0; k < count; ++k)
      append(samples, curve, between(domain.start, domain.end, k, count - 1), Side::right);
    return samples;
  }
  for (std::size_t i = 0; i < segments; ++i) {
    const double from = knots.times()[i], to = knots.times()[i + 1];
    const double share = (to - from) / (domain.end - domain.start);
    const auto steps = static_cast<std::size_t>(std::max(3.0, std::ceil(share * static_cast<double>(count))));
    for (std::size_t k = 0; k <= steps; ++k)
      append(samples, curve, between(from, to, k, steps), k == steps ? Side::left : Side::right);
  }
  return samples;
}

std::vector<double> errors_to(const PagePath& reference, const PagePath& path) {
  std::vector<double> errors(path.times.size(), std::numeric_limits<double>::quiet_NaN());
  if (reference.times.size() < 2) return errors;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double t = path.times[i];
    if (t < reference.times.front() || t > reference.times.back()) continue;
    const auto after = std::upper_bound(reference.times.begin() + 1, reference.times.end() - 1, t);
    const auto index = static_cast<std::size_t>(after - reference.times.begin());
    errors[i] = angular_distance(path.orientations[i], on_reference(reference, index, t)) / degree;
  }
  return errors;
}

PagePath thinned(const PagePath& path, std::size_t count) {
  const std::size_t size = path.times.size();
  if (size <= count || count < 2) return path;
  PagePath few;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = k * (size - 1) / (count - 1);
    few.times.push_back(path.times[i]);
    few.orientations.push_back(path.orientations[i]);
  }
  return few;
}

}  // namespace orispline::report
