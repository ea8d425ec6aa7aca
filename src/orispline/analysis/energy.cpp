// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <orispline/analysis/quadrature.hpp>
#include <orispline/analysis/rounding.hpp>
#include <orispline/analysis/segment_motions.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Integrals that are rounding altogether, on a segment of h seconds.
Figures<3> rounding_of(double h, double moment) {
  const double acceleration = rounding_of_rates(h, 2), jerk = rounding_of_rates(h, 3);
  return {h * acceleration * acceleration, h * jerk * jerk, h * moment * moment * acceleration * acceleration};
}

}  // namespace

Energies energies(const AnyCurve& curve, const Eigen::Matrix3d& inertia) {
  const auto knots = curve.knots().times();
  const bool is_unit = inertia == Eigen::Matrix3d::Identity();  // whose torque is α
  Figures<3> sum = Figures<3>::Zero();
  for (std::size_t segment = 0; segment + 1 < knots.size(); ++segment) {
    SegmentMotions motions(curve, segment, MotionPart::rates);
    if (motions.is_gap()) continue;
    const auto integrands = [&](std::span<const double> times, std::span<Figures<3>> values) {
      motions.evaluate(times);
      for (std::size_t i = 0; i < times.size(); ++i) {
        const double acceleration = motions.angular_acceleration(i).squaredNorm();
        values[i] = {acceleration, motions.angular_jerk(i).squaredNorm(), acceleration};
      }
      if (!is_unit)
        for (std::size_t i = 0; i < times.size(); ++i) values[i][2] = torque(motions.rates(i), inertia).squaredNorm();
    };
    const double start = knots[segment], end = knots[segment + 1];
    sum += adaptive_integral<3>(integrands, start, end, rounding_of(end - start, inertia.norm()));
  }
  return {.acceleration = sum[0], .jerk = sum[1], .torque = sum[2]};
}

std::optional<double> least_energy(const Keyframes& keys) {
  if (keys.size() < 2 || keys.size() > most_keys_for_least_energy) return std::nullopt;
  const auto of_orientations =
      Keyframes::make({.times = {keys.times().begin(), keys.times().end()},
                       .orientations = {keys.orientations().begin(), keys.orientations().end()}});
  if (!of_orientations) return std::nullopt;
  const auto curve = make_curve("least", *of_orientations);
  return curve ? std::optional(energies(*curve).acceleration) : std::nullopt;
}

}}  // namespace orispline
