// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <orispline/analysis/quadrature.hpp>
#include <orispline/analysis/rounding.hpp>
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
  Figures<3> sum = Figures<3>::Zero();
  for (std::size_t segment = 0; segment + 1 < knots.size(); ++segment) {
    const auto integrands = [&](double t) {
      const Motion m = curve.motion_on(segment, t);
      return Figures<3>(m.angular_acceleration.squaredNorm(), m.angular_jerk.squaredNorm(),
                        torque(m, inertia).squaredNorm());
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
