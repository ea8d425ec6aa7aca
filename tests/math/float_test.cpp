// SPDX-License-Identifier: Apache-2.0
// The same templates over float: accurate to a few of its own ulp.
#include <orispline/math/geodesic.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <support/specimens.hpp>

namespace orispline { namespace {

constexpr double few_ulp = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon());

double error(const Quaternion<float>& found, const Eigen::Quaterniond& wanted) {
  return (found.coeffs().cast<double>() - wanted.coeffs()).cwiseAbs().maxCoeff();
}

TEST(Float, ExpIsAccurateToAFewUlp) {
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    const Eigen::Vector3f rounded = phi.cast<float>();
    EXPECT_LE(error(exp<float>(rounded), exp<double>(rounded.cast<double>())), few_ulp) << phi.transpose();
  }
}

TEST(Float, LogIsAccurateToAFewUlpOfItsSize) {
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    const Quaternion<float> q = exp<float>(phi.cast<float>());
    const Eigen::Vector3d wanted = log<double>(q.cast<double>());
    EXPECT_LE((log<float>(q).cast<double>() - wanted).norm(), few_ulp * wanted.norm()) << phi.transpose();
  }
}

TEST(Float, JacobiansAreAccurateToAFewUlp) {
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    const Eigen::Vector3f rounded = phi.cast<float>();
    const Eigen::Matrix3d wanted = right_jacobian<double>(rounded.cast<double>());
    EXPECT_LE((right_jacobian<float>(rounded).cast<double>() - wanted).cwiseAbs().maxCoeff(), 4 * few_ulp)
        << phi.transpose();
  }
}

TEST(Float, SlerpAndSquadAgreeWithDouble) {
  const Quaternion<float> p = exp<float>(Eigen::Vector3f(0.3f, -0.5f, 0.8f)),
                          q = exp<float>(Eigen::Vector3f(-0.9f, 0.4f, 1.2f));
  for (const float s : {0.0f, 0.25f, 0.75f, 1.0f}) {
    const double ds = static_cast<double>(s);
    const Eigen::Quaterniond dp = p.cast<double>(), dq = q.cast<double>();
    EXPECT_LE(error(slerp<float>(p, q, s), slerp<double>(dp, dq, ds)), few_ulp);
    EXPECT_LE(error(squad<float>(p, q, p, q, s), squad<double>(dp, dq, dp, dq, ds)), 2 * few_ulp);
    EXPECT_LE(error(pow<float>(q, s), pow<double>(dq, ds)), few_ulp);
  }
}

TEST(Float, JetsOfFloatDifferentiate) {
  using J = Jet<float, 2>;
  const auto q = exp<J>(constant<J>(Eigen::Vector3d(0, 0, 1)) * J::variable(0.5f));
  EXPECT_NEAR(static_cast<double>(q.z().c[1]), 0.5 * std::cos(0.25), few_ulp);
  EXPECT_NEAR(static_cast<double>(q.w().c[1]), -0.5 * std::sin(0.25), few_ulp);
}

}}  // namespace orispline
