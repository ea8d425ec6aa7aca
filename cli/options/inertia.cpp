// SPDX-License-Identifier: Apache-2.0
#include "options/inertia.hpp"

#include <Eigen/Cholesky>

#include <orispline/analysis/torque.hpp>

namespace orispline::cli {

Expected<Eigen::Matrix3d> inertia_in(OptionText option) {
  const auto numbers = numbers_in(option);
  if (!numbers || (numbers->size() != 3 && numbers->size() != 6))
    return wanted(option, "three principal moments, or JXX,JYY,JZZ,JXY,JXZ,JYZ");
  Eigen::Matrix3d inertia = Eigen::Vector3d(numbers->data()).asDiagonal();
  if (numbers->size() == 6) {
    inertia(0, 1) = inertia(1, 0) = (*numbers)[3];
    inertia(0, 2) = inertia(2, 0) = (*numbers)[4];
    inertia(1, 2) = inertia(2, 1) = (*numbers)[5];
  }
  if (Eigen::LLT<Eigen::Matrix3d>(inertia).info() != Eigen::Success)
    return wanted(option, "a positive definite inertia");
  return inertia;
}

std::optional<std::string> inertia_warning(const Eigen::Matrix3d& inertia) {
  if (is_physical_inertia(inertia)) return std::nullopt;
  return "--inertia: one principal moment is greater than the sum of the two others, as no rigid body has it";
}

}  // namespace orispline::cli
