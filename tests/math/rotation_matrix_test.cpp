// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/rotation_matrix.hpp>

#include <gtest/gtest.h>

#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::Dice;
using testing_support::near;
using testing_support::pi;

/// The matrix by Rodrigues' formula, which knows no quaternion.
Eigen::Matrix3d matrix_of(const Eigen::Vector3d& axis, double angle) {
  const Eigen::Matrix3d k = skew<double>(axis);
  return Eigen::Matrix3d::Identity() + std::sin(angle) * k + (1.0 - std::cos(angle)) * k * k;
}

TEST(RotationMatrix, BecomesTheQuaternionOfItsAxisAndAngle) {
  for (const Eigen::Vector3d& axis : testing_support::specimen_axes())
    for (const double angle : {0.0, 1e-12, 1e-8, 1e-4, 0.5, 2.0, 2.0944, 3.0, pi - 1e-8, pi - 1e-12, pi}) {
      const Eigen::Quaterniond q = quaternion_from_matrix(matrix_of(axis, angle));
      EXPECT_LE(angular_distance(q, exp<double>(angle * axis)), tolerance::algebra) << angle;
      EXPECT_NEAR(q.norm(), 1.0, tolerance::exact);
    }
}

TEST(RotationMatrix, IsAccurateInEveryBranch) {
  Dice dice(41);
  for (int n = 0; n < 1000; ++n) {
    const Eigen::Vector3d axis = dice.vector().normalized();
    const double angle = dice.between(0.0, 2 * pi);
    EXPECT_LE(angular_distance(quaternion_from_matrix(matrix_of(axis, angle)), exp<double>(angle * axis)),
              tolerance::algebra);
  }
}

TEST(RotationMatrix, MakesTheLargestComponentPositive) {
  Dice dice(43);
  for (int n = 0; n < 200; ++n) {
    const Eigen::Quaterniond q = exp<double>(6.0 * dice.vector());
    Eigen::Index largest = 0;
    q.coeffs().cwiseAbs().maxCoeff(&largest);
    const Eigen::Vector4d wanted = q.coeffs()[largest] > 0.0 ? q.coeffs() : -q.coeffs();
    EXPECT_TRUE(near(quaternion_from_matrix(q.toRotationMatrix()).coeffs(), wanted, tolerance::algebra));
  }
}

TEST(RotationMatrix, ThatIsRoundedStaysNear) {
  Dice dice(42);
  for (int n = 0; n < 200; ++n) {
    const Eigen::Vector3d phi = 3.0 * dice.vector();
    Eigen::Matrix3d m = matrix_of(phi.normalized(), phi.norm());
    for (double& element : m.reshaped()) element = std::round(element * 1e4) / 1e4;
    EXPECT_LE(angular_distance(quaternion_from_matrix(m), exp<double>(phi)), 2e-4);
  }
}

TEST(OrthonormalityError, MeasuresTheColumns) {
  const Eigen::Matrix3d r = matrix_of({0.36, 0.48, 0.8}, 1.2);
  EXPECT_LE(orthonormality_error(r), tolerance::exact);
  EXPECT_NEAR(orthonormality_error(1.01 * r), 0.0201, tolerance::algebra);
  Eigen::Matrix3d sheared = r;
  sheared.col(0) += 0.001 * r.col(1);
  EXPECT_NEAR(orthonormality_error(sheared), 0.001, 1e-12);
}

}}  // namespace orispline
