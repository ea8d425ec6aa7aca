// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/energy.hpp>

#include <orispline/analysis/quadrature.hpp>
#include <orispline/analysis/rounding.hpp>
#include <orispline/curve/torque.hpp>

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

}}  // namespace orispline
