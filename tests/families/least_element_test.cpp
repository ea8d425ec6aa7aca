// SPDX-License-Identifier: Apache-2.0
// The second derivatives of an element of least energy against differences of its first ones.
#include <gtest/gtest.h>

#include <orispline/families/least/element.hpp>
#include <support/random_motion.hpp>
#include <support/specimens.hpp>

namespace orispline::families { namespace {

using namespace testing_support;

using Unknowns = Eigen::Matrix<double, 18, 1>;

template <LeastOf F>
void expect_exact_curvature(double turn, double h) {
  Dice dice(25);
  Eigen::Matrix3d inertia;
  inertia << 2.0, 0.3, -0.2, 0.3, 3.0, 0.4, -0.2, 0.4, 2.5;
  const Eigen::Vector3d step = turn * dice.vector().normalized();
  ChartEnd<3> leaving, arriving;
  leaving << dice.vector(), 3.0 * dice.vector();
  arriving << dice.vector(), 3.0 * dice.vector();
  const auto gradient = [&](const Unknowns& x) {
    const Eigen::Vector3d first = x.head<3>(), second = x.segment<3>(9), back = -first;
    const Eigen::Quaterniond between = exp<double>(back) * exp<double>(step) * exp<double>(second);
    const auto e = LeastElement<F>::linearised(log<double>(between), leaving + x.segment<6>(3),
                                               arriving + x.segment<6>(12), h, inertia);
    Unknowns slope = e.jacobian.transpose() * e.residual;
    slope.template head<3>() = (right_jacobian<double>(first).transpose() * slope.template head<3>()).eval();
    slope.template segment<3>(9) = (right_jacobian<double>(second).transpose() * slope.template segment<3>(9)).eval();
    return slope;
  };
  const auto curved = LeastElement<F>::curved(step, leaving, arriving, h, inertia);
  const double size = curved.hessian.norm(), reach = 1e-3;
  for (Eigen::Index k = 0; k < 18; ++k) {
    const Unknowns x = reach * Unknowns::Unit(k), twice = 2.0 * x;
    const Unknowns column =
        (8.0 * (gradient(x) - gradient(-x)) - (gradient(twice) - gradient(-twice))) / (12.0 * reach);
    EXPECT_LE((column - curved.hessian.col(k)).norm(), 1e-11 * size) << k;
  }
  EXPECT_LE((curved.gradient - gradient(Unknowns::Zero())).norm(), 1e-14 * curved.gradient.norm());
}

TEST(LeastElement, HasExactSecondDerivatives) {
  for (const double turn : {0.0, 0.3, 1.0, 2.5})
    for (const double h : {1.0, 0.3}) {
      expect_exact_curvature<LeastOf::acceleration>(turn, h);
      expect_exact_curvature<LeastOf::torque>(turn, h);
      expect_exact_curvature<LeastOf::jerk>(turn, h);
    }
}

}}  // namespace orispline::families
