// SPDX-License-Identifier: Apache-2.0
// Duals against jets: every direction has the derivative that a jet along it has.
#include <orispline/math/jet.hpp>

#include <gtest/gtest.h>

#include <orispline/math/geodesic.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

using Dual6 = Dual<6>;
using Jet1 = Jet<double, 1>;

/// f of two vectors over duals has the values and derivatives that jets along the six directions give.
template <class Function>
void expect_as_jets(Function f, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Vector3<Dual6> x = constant<Dual6>(a), y = constant<Dual6>(b);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    x[static_cast<Eigen::Index>(axis)] = Dual6::variable(a[static_cast<Eigen::Index>(axis)], axis);
    y[static_cast<Eigen::Index>(axis)] = Dual6::variable(b[static_cast<Eigen::Index>(axis)], 3 + axis);
  }
  const auto found = f(x, y);
  for (std::size_t k = 0; k < Dual6::directions; ++k) {
    Vector3<Jet1> along_x = constant<Jet1>(a), along_y = constant<Jet1>(b);
    (k < 3 ? along_x : along_y)[static_cast<Eigen::Index>(k % 3)].c[1] = 1.0;
    const auto wanted = f(along_x, along_y);
    for (Eigen::Index i = 0; i < wanted.size(); ++i) {
      const double size = std::max(1.0, std::abs(wanted(i).c[1]));
      EXPECT_NEAR(found(i).value, wanted(i).c[0], tolerance::algebra) << "component " << i;
      EXPECT_NEAR(found(i).slope[k], wanted(i).c[1], tolerance::algebra * size) << "component " << i << " by " << k;
    }
  }
}

TEST(Dual, FieldOperationsHaveTheDerivativesOfJets) {
  const auto f = [](const auto& x, const auto& y) {
    using T = typename std::decay_t<decltype(x)>::Scalar;
    Vector3<T> z = x.cross(y) * T(2.0) - y / T(3.0) + x * (x.dot(y) / y.squaredNorm());
    z[0] /= x[1] - T(4.0);
    z[1] *= -y[2];
    z[2] *= sqrt_of(T(x.squaredNorm()));
    return z;
  };
  Dice dice(12);
  for (int i = 0; i < 20; ++i) expect_as_jets(f, dice.vector(), dice.vector());
}

TEST(Dual, ExpLogAndTheJacobianHaveTheDerivativesOfJetsAtEveryAngle) {
  Dice dice(13);
  for (const double angle : {1e-9, 1e-3, 0.3, 1.5, 2.0, 2.9, 3.1, 4.0, 5.0, 6.0}) {
    SCOPED_TRACE(angle);
    const Eigen::Vector3d a = angle * dice.vector().normalized(), b = 0.1 * dice.vector();
    expect_as_jets(
        [](const auto& x, const auto& y) {
          using T = typename std::decay_t<decltype(x)>::Scalar;
          return log<T>(exp<T>(x) * exp<T>(y));
        },
        a, b);
    expect_as_jets(
        [](const auto& x, const auto& y) {
          using T = typename std::decay_t<decltype(x)>::Scalar;
          return Vector3<T>(right_jacobian_inverse<T>(x) * (right_jacobian<T>(y) * y));
        },
        a, b);
  }
}

TEST(Dual, PlainMatricesAndVectorsMixWithDuals) {
  const Vector3<Dual6> x(Dual6::variable(1.0, 0), Dual6::variable(2.0, 1), Dual6::variable(3.0, 2));
  const Eigen::Matrix3d m = skew<double>({0.3, -0.2, 0.7});
  const Vector3<Dual6> product = m * x;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k) EXPECT_EQ(product[i].slope[static_cast<std::size_t>(k)], m(i, k));
}

}}  // namespace orispline
