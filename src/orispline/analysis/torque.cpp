// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/torque.hpp>

#include <Eigen/Eigenvalues>

#include <orispline/base/formatted.hpp>

namespace orispline {
namespace {

constexpr double rounding_of_tensor = 1e-12;  // of an inertia tensor that was computed

}  // namespace

Expected<Eigen::Matrix3d> checked_inertia(const Eigen::Matrix3d& inertia) {
  const auto refused = [](std::string message) { return failure(ErrorCode::bad_argument, std::move(message)); };
  if (!inertia.allFinite() || (inertia - inertia.transpose()).norm() > rounding_of_tensor * inertia.norm())
    return refused("the inertia is not symmetric, wanted a symmetric tensor");
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  const std::string found =
      formatted("the inertia has the principal moments {:.6g}, {:.6g}, {:.6g}", moments[0], moments[1], moments[2]);
  if (!(moments[0] > 0.0)) return refused(found + ", wanted all of them greater than 0");
  return inertia;
}

bool is_physical_inertia(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  return moments[2] <= (moments[0] + moments[1]) * (1.0 + rounding_of_tensor);
}

}  // namespace orispline
