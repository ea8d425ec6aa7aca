// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace orispline::testing_support {

/// exp of a rotation vector [rad].
inline Eigen::Quaterniond turned_by(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  return angle > 0.0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, phi / angle)) : Eigen::Quaterniond::Identity();
}

/// A curve as the page draws it from its data, word by word as studio/report/README.md states it.
struct DrawnAsStated {
  std::vector<double> t;  ///< [s]
  std::vector<Eigen::Quaterniond> q;
  std::vector<Eigen::Vector3d> w;  ///< [rad/s], body
  bool is_straight = false;

  [[nodiscard]] Eigen::Quaterniond operator()(double time) const {
    const auto after = std::upper_bound(t.begin() + 1, t.end() - 1, time);
    const auto i = static_cast<std::size_t>(after - t.begin()) - 1;
    const double h = t[i + 1] - t[i];
    if (!(h > 0.0)) return q[i + 1].normalized();
    const double u = std::clamp((time - t[i]) / h, 0.0, 1.0);
    const Eigen::Quaterniond from = q[i].normalized(), to = q[i + 1].normalized();
    if (is_straight) return from.slerp(u, to);
    const Eigen::Vector3d leaving = h / 3.0 * w[i], arriving = h / 3.0 * w[i + 1];
    const Eigen::AngleAxisd left(turned_by(-leaving) * from.conjugate() * to * turned_by(-arriving));
    const double turn = left.angle() > M_PI ? left.angle() - 2.0 * M_PI : left.angle();
    return from * turned_by((1.0 - std::pow(1.0 - u, 3)) * leaving) *
           turned_by((3.0 * u * u - 2.0 * u * u * u) * turn * left.axis()) * turned_by(u * u * u * arriving);
  }
};

}  // namespace orispline::testing_support
