// SPDX-License-Identifier: Apache-2.0
// Banded matrices against the same as dense ones.
#include <orispline/math/banded_lu.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

std::size_t distance(std::size_t i, std::size_t j) { return i > j ? i - j : j - i; }

/// Entries of any size, zeros on the diagonal, the first one too: it cannot be eliminated without exchanges.
BandedMatrix some_matrix(std::size_t size, std::size_t band) {
  Dice dice(417);
  BandedMatrix a(size, band);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      if (distance(i, j) <= band) a(i, j) = dice.between(-1.0, 1.0);
  for (std::size_t i = 0; i < size; i += 4) a(i, i) = 0.0;
  return a;
}

Eigen::MatrixXd dense(const BandedMatrix& a) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(index(a.size()), index(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      if (distance(i, j) <= a.band()) all(index(i), index(j)) = a(i, j);
  return all;
}

Eigen::VectorXd some_vector(std::size_t size) {
  Dice dice(5);
  Eigen::VectorXd v(index(size));
  for (double& x : v) x = dice.between(-1.0, 1.0);
  return v;
}

TEST(BandedLu, SolvesWhereItMustExchangeRows) {
  for (const std::size_t band : {1u, 2u, 5u, 8u})
    for (const std::size_t size : {2u, 3u, 7u, 10u, 40u}) {
      SCOPED_TRACE(testing::Message() << "band " << band << ", size " << size);
      const BandedMatrix a = some_matrix(size, band);
      const Eigen::VectorXd b = some_vector(size);
      ASSERT_TRUE(Eigen::FullPivLU<Eigen::MatrixXd>(dense(a)).isInvertible());
      const BandedLu lu(a);
      ASSERT_TRUE(lu.regular());
      EXPECT_TRUE(near(dense(a) * lu.solve(b), b, tolerance::series));
    }
}

TEST(BandedLu, SolvesOneEquation) {
  BandedMatrix a(1, 5);
  a(0, 0) = 4.0;
  EXPECT_EQ(BandedLu(a).solve(Eigen::VectorXd::Constant(1, 2.0))[0], 0.5);
}

TEST(BandedLu, IsNotRegularWithoutAPivotThatIsANumber) {
  EXPECT_FALSE(BandedLu(BandedMatrix(3, 2)).regular());
  BandedMatrix same_rows(2, 1), no_number(2, 1);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) same_rows(i, j) = 1.0;
  no_number(0, 0) = no_number(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(BandedLu(same_rows).regular());
  EXPECT_FALSE(BandedLu(no_number).regular());
}

TEST(BandedMatrix, HasTheNormalMatrixAndTheTransposeOfTheDenseOne) {
  for (const std::size_t size : {1u, 4u, 20u}) {
    const BandedMatrix a = some_matrix(size, 3);
    const Eigen::MatrixXd all = dense(a);
    const Eigen::VectorXd x = some_vector(size);
    EXPECT_TRUE(near(dense(normal_matrix(a)), all.transpose() * all, tolerance::algebra));
    EXPECT_TRUE(near(transposed_product(a, x), all.transpose() * x, tolerance::algebra));
  }
}

TEST(BandedMatrix, AddsBlocks) {
  BandedMatrix a(6, 5);
  const Eigen::Matrix3d block = Eigen::Vector3d(1.0, 2.0, 3.0) * Eigen::RowVector3d(1.0, 10.0, 100.0);
  a.add(0, 3, block);
  a.add(0, 3, block);
  EXPECT_EQ(Eigen::Matrix3d(dense(a).topRightCorner<3, 3>()), Eigen::Matrix3d(2.0 * block));
}

}}  // namespace orispline
