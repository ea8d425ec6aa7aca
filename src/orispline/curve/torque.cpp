// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/motion.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/math/eigensystem.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double rounding_of_tensor = 1e-12;  // of an inertia tensor that was computed

}  // namespace

Expected<Eigen::Matrix3d> checked_inertia(const Eigen::Matrix3d& inertia) {
  if (!inertia.allFinite() || (inertia - inertia.transpose()).norm() > rounding_of_tensor * inertia.norm())
    return bad_option("inertia", "found a tensor that is not symmetric, wanted a symmetric one");
  const Eigen::Vector3d moments = eigensystem<3>(inertia).values;
  if (moments[0] > 0.0) return inertia;
  return bad_option("inertia",
                    formatted("found the principal moments {:.6g}, {:.6g}, {:.6g}, wanted all of them greater "
                              "than 0",
                              moments[0], moments[1], moments[2]));
}

bool is_physical_inertia(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d moments = eigensystem<3>(inertia).values;
  return moments[2] <= (moments[0] + moments[1]) * (1.0 + rounding_of_tensor);
}

std::vector<Warning> warnings_of(const Eigen::Matrix3d& inertia) {
  if (is_physical_inertia(inertia)) return {};
  return {{.code = "no_rigid_body",
           .message = "one principal moment is greater than the sum of the two others, which no rigid body has",
           .option = "inertia"}};
}

}}  // namespace orispline
