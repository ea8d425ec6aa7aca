// SPDX-License-Identifier: Apache-2.0
// exp, log and pow against a table of 60-digit values, and along curves with their derivatives.
#include <orispline/math/so3.hpp>

#include <gtest/gtest.h>

#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::near;
using testing_support::pi;

Eigen::Vector3d argument_vector(const DataTable::Row& row) { return row.vector("x", "y", "z"); }
Eigen::Quaterniond argument_quaternion(const DataTable::Row& row) { return row.quaternion("w", "x", "y", "z"); }
Eigen::Vector3d result_vector(const DataTable::Row& row) { return row.vector("result_x", "result_y", "result_z"); }
Eigen::Quaterniond result_quaternion(const DataTable::Row& row) {
  return row.quaternion("result_w", "result_x", "result_y", "result_z");
}

double purely_relative_error(const Eigen::Vector3d& found, const Eigen::Vector3d& wanted) {
  return (found - wanted).stableNorm() / wanted.stableNorm();
}

TEST(QuaternionByNames, IsMadeOfAnyMixtureOfNumbers) {
  const Eigen::Quaterniond half(0.0, 1.0, 0.0, 0.0);
  EXPECT_EQ(quaternion_wxyz(0, 1, 0, 0).coeffs(), half.coeffs());
  EXPECT_EQ(quaternion_wxyz(0, 1U, 0.0, 0L).coeffs(), half.coeffs());
  EXPECT_EQ(quaternion_xyzw(1, 0, 0, 0.0).coeffs(), half.coeffs());
  static_assert(std::is_same_v<decltype(quaternion_wxyz(1.0F, 0.0F, 0.0F, 0.0F)), Eigen::Quaternionf>);
}

TEST(Exp, OfThreeAtOnceHasTheBitsOfEach) {
  const DataTable table("so3.csv");
  const auto rows = table.rows_where("function", "exp");
  for (std::size_t i = 0; i + 2 < rows.size(); ++i) {
    const std::array phi{argument_vector(rows[i]), argument_vector(rows[i + 1]), argument_vector(rows[i + 2])};
    const auto found = exp_of_each(phi);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(found[k].coeffs(), exp<double>(phi[k]).coeffs()) << "phi = " << phi[k].transpose();
  }
}

TEST(Exp, IsAccurateFromTinyToFullTurns) {
  const DataTable table("so3.csv");
  const auto rows = table.rows_where("function", "exp");
  ASSERT_GT(rows.size(), 200u);
  for (const auto& row : rows) {
    const Eigen::Vector3d phi = argument_vector(row);
    const Eigen::Quaterniond found = exp<double>(phi), wanted = result_quaternion(row);
    EXPECT_TRUE(near(found, wanted, tolerance::exact)) << "phi = " << phi.transpose();
    if (phi.stableNorm() < 3.0) {
      EXPECT_LE(purely_relative_error(found.vec(), wanted.vec()), tolerance::exact) << "phi = " << phi.transpose();
    }
  }
}

TEST(Log, HasTheStatedRelativeErrorEverywhere) {
  const DataTable table("so3.csv");
  const auto rows = table.rows_where("function", "log");
  ASSERT_GT(rows.size(), 200u);
  for (const auto& row : rows) {
    const Eigen::Quaterniond q = argument_quaternion(row);
    EXPECT_LE(purely_relative_error(log<double>(q), result_vector(row)), tolerance::log_relative)
        << "q (xyzw) = " << q.coeffs().transpose();
  }
}

TEST(Pow, IsExpOfTheScaledLog) {
  const DataTable table("so3.csv");
  const auto rows = table.rows_where("function", "pow");
  ASSERT_GT(rows.size(), 200u);
  for (const auto& row : rows)
    EXPECT_TRUE(
        near(pow<double>(argument_quaternion(row), row.number("s")), result_quaternion(row), 2 * tolerance::exact))
        << "q (xyzw) = " << argument_quaternion(row).coeffs().transpose() << ", s = " << row.number("s");
}

TEST(Log, OfTheIdentityIsZero) { EXPECT_EQ(log<double>(Eigen::Quaterniond::Identity()), Eigen::Vector3d::Zero()); }

TEST(Log, OfMinusOneIsAFullTurnAboutX) {
  EXPECT_EQ(log<double>(quaternion_wxyz(-1.0, 0.0, 0.0, 0.0)), Eigen::Vector3d(2 * pi, 0, 0));
}

TEST(Log, SoNearMinusOneThatItsAxisCannotBeToldIsAFullTurnAboutX) {
  for (const double off : {1e-317, -3e-308})
    EXPECT_EQ(log<double>(Eigen::Quaterniond(-1.0, 0.0, off, 0.0)), Eigen::Vector3d(2.0 * pi, 0.0, 0.0)) << off;
  EXPECT_EQ(log<double>(Eigen::Quaterniond(1.0, 0.0, 1e-317, 0.0)), Eigen::Vector3d(0.0, 2.0 * 1e-317, 0.0));
}

TEST(Log, NeverFlipsASign) {
  const Eigen::Vector3d beyond_pi(0.0, 4.0, 0.0);

  const Eigen::Vector3d back = log<double>(exp<double>(beyond_pi));

  EXPECT_TRUE(near(back, beyond_pi, tolerance::exact));
}

TEST(Log, InvertsExpForEverySpecimen) {
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    const double angle = phi.stableNorm();
    if (angle > 2 * pi - 1e-3) continue;  // there the rounding of q alone turns the axis
    EXPECT_TRUE(near(log<double>(exp<double>(phi)), phi, tolerance::algebra / (2 * pi - angle))) << phi.transpose();
  }
}

TEST(Increment, LeadsFromOneOrientationToTheNextWithItsSign) {
  const Eigen::Quaterniond from = exp<double>(Eigen::Vector3d(0.4, 1.0, -0.3));
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    const Eigen::Quaterniond to = from * exp<double>(phi);
    EXPECT_TRUE(near(from * exp<double>(increment<double>(from, to)), to, tolerance::algebra)) << phi.transpose();
  }
}

TEST(ToWorld, RotatesAsTheMatrixDoes) {
  const Eigen::Vector3d v(0.3, -1.2, 0.7);
  for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
    const Eigen::Quaterniond q = exp<double>(phi);
    EXPECT_TRUE(near(to_world<double>(q, v), q.toRotationMatrix() * v, tolerance::algebra));
    EXPECT_TRUE(near(to_body<double>(q, v), q.toRotationMatrix().transpose() * v, tolerance::algebra));
  }
}

TEST(Skew, IsTheCrossProduct) {
  const Eigen::Vector3d a(1.0, 2.0, 3.0), b(-0.5, 4.0, 0.25);
  EXPECT_EQ(skew<double>(a) * b, a.cross(b));
}

using Jet3 = Jet<double, 3>;

Vector3<Jet3> rotation_vector_jet(const DataTable::Row& row) {
  Vector3<Jet3> phi(Jet3(0.0), Jet3(0.0), Jet3(0.0));
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string order = std::to_string(k);
    const Eigen::Vector3d c = row.vector("px" + order, "py" + order, "pz" + order);
    for (int j = 0; j < 3; ++j) phi(j).c[k] = c(j);
  }
  return phi;
}

TEST(ExpOfJets, HasTheDerivativesOnBothSidesOfEveryThreshold) {
  const DataTable table("so3_jets.csv");
  ASSERT_GT(table.size(), 30u);
  for (const auto& row : table.rows()) {
    const Vector3<Jet3> phi = rotation_vector_jet(row);
    const Quaternion<Jet3> q = exp<Jet3>(phi);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::string n = std::to_string(k);
      const Eigen::Quaterniond found = quaternion_wxyz(q.w().c[k], q.x().c[k], q.y().c[k], q.z().c[k]);
      EXPECT_TRUE(near(found, row.quaternion("qw" + n, "qx" + n, "qy" + n, "qz" + n), tolerance::algebra))
          << "order " << k << " at " << row.vector("px0", "py0", "pz0").transpose();
    }
  }
}

TEST(LogOfJets, OfAFullTurnIsThatOfNumbersAndTurnsOnAboutItsAxis) {
  using J = Jet<double, 3>;
  const auto minus = [](const Quaternion<J>& q) { return Quaternion<J>(-q.w(), -q.x(), -q.y(), -q.z()); };
  const auto turning = [](const Eigen::Vector3d& rate) { return exp<J>(constant<J>(rate) * J::variable(0.0)); };
  for (const Eigen::Vector3d& rate :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.3, 0, 0), Eigen::Vector3d(-0.3, 0.2, 0.5)}) {
    const Vector3<J> turn = log<J>(minus(turning(rate)));
    EXPECT_EQ(turn.x().c[0], 2.0 * pi);
    EXPECT_NEAR(turn.x().c[1], rate.x(), tolerance::exact);
    for (const J& component : {turn.y(), turn.z()})
      for (const double c : component.c) EXPECT_EQ(c, 0.0);
    for (const std::size_t order : {2u, 3u}) EXPECT_NEAR(turn.x().c[order], 0.0, tolerance::algebra);
  }
  const Eigen::Quaterniond near_turn(-1.0, 0.0, 1e-120, 0.0);
  const Vector3<J> turn = log<J>(constant<J>(near_turn));
  const Eigen::Vector3d wanted = log<double>(near_turn);
  for (Eigen::Index axis = 0; axis < 3; ++axis) EXPECT_NEAR(turn[axis].c[0], wanted[axis], tolerance::series);
}

TEST(LogOfJets, HasTheDerivativesOnBothSidesOfEveryThreshold) {
  const DataTable table("so3_jets.csv");
  for (const auto& row : table.rows()) {
    Quaternion<Jet3> q;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::string n = std::to_string(k);
      const Eigen::Quaterniond c = row.quaternion("qw" + n, "qx" + n, "qy" + n, "qz" + n);
      q.w().c[k] = c.w(), q.x().c[k] = c.x(), q.y().c[k] = c.y(), q.z().c[k] = c.z();
    }
    const Vector3<Jet3> found = log<Jet3>(q), wanted = rotation_vector_jet(row);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_TRUE(near(Eigen::Vector3d(found.x().c[k], found.y().c[k], found.z().c[k]),
                       Eigen::Vector3d(wanted.x().c[k], wanted.y().c[k], wanted.z().c[k]), tolerance::series))
          << "order " << k << " at " << row.vector("px0", "py0", "pz0").transpose();
  }
}

}}  // namespace orispline
