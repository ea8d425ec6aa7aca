// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/correction.hpp>

#include <Eigen/LU>

#include <orispline/curve/composition.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Bend bend_to(const Motion& motion, const Eigen::Vector3d& by, const Eigen::Vector3d& rate,
             const Eigen::Vector3d& acceleration) {
  const Eigen::Matrix3d back = right_jacobian<double>(by).inverse();
  const auto with = [&](const Eigen::Vector3d& of_bend) {
    Vector3<Jet<double, 3>> moving;
    for (Eigen::Index k = 0; k < 3; ++k) {
      moving[k] = Jet<double, 3>(by[k]);
      moving[k].c[1] = of_bend[k];
    }
    return product(motion, motion_from_jet(exp(moving)));
  };
  const Eigen::Vector3d of_bend = back * (rate - with(Eigen::Vector3d::Zero()).angular_velocity);
  return {by, of_bend, back * (acceleration - with(of_bend).angular_acceleration)};
}

Bend bend_to(const LinearMotion& motion, const Eigen::Vector3d& by, const Eigen::Vector3d& rate,
             const Eigen::Vector3d& acceleration) {
  return {by, rate - motion.velocity, acceleration - motion.acceleration};
}

}}  // namespace orispline
