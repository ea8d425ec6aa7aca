// SPDX-License-Identifier: Apache-2.0
// Chains of rates: the derivatives that they tell are those of their equations.
#include <orispline/curve/rate_chain.hpp>

#include <gtest/gtest.h>

#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

template <class Piece>
RateChain<Piece> some_chain(std::size_t pieces, RateConditions conditions) {
  Dice dice(88);
  std::vector<Eigen::Vector3d> increments;
  std::vector<double> steps;
  for (std::size_t i = 0; i < pieces; ++i) {
    increments.push_back(2.0 * dice.vector());
    steps.push_back(dice.between(0.2, 2.0));
  }
  conditions.nu = PerKey(std::vector{1.5});
  return RateChain<Piece>(increments, steps, conditions, 1.0, nullptr);
}

Eigen::MatrixXd matrix_of(std::size_t size, const std::function<void(const chain::TakeBlock&)>& tell) {
  const auto rows = 3 * static_cast<Eigen::Index>(size);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows, rows);
  tell([&](std::size_t equation, std::size_t unknown, const Eigen::Matrix3d& block) {
    all.block<3, 3>(3 * static_cast<Eigen::Index>(equation), 3 * static_cast<Eigen::Index>(unknown)) += block;
  });
  return all;
}

template <class Piece>
void expect_own_derivatives(std::size_t pieces, const RateConditions& conditions) {
  SCOPED_TRACE(testing::Message() << pieces << (conditions.closed ? " closed" : " open"));
  const RateChain<Piece> problem = some_chain<Piece>(pieces, conditions);
  const auto over_duals = [&](const chain::DualSteps& steps) { return problem.template residual<chain::Dual9>(steps); };
  const Eigen::MatrixXd told = matrix_of(problem.size(), [&](const auto& take) { problem.jacobian(take); });
  const Eigen::MatrixXd wanted = matrix_of(problem.size(), [&](const auto& take) {
    chain::differentiate(problem.size(), problem.closed(), over_duals, take);
  });
  EXPECT_GT(wanted.norm(), 0.1);
  EXPECT_LT((told - wanted).norm(), tolerance::algebra * std::max(1.0, wanted.norm()));
}

template <class Piece>
class RateChainOf : public testing::Test {};
using Pieces = testing::Types<FlatPiece, SlerpBezierPiece, LeftChartPiece>;
TYPED_TEST_SUITE(RateChainOf, Pieces);

TYPED_TEST(RateChainOf, TellsTheDerivativesOfItsEquations) {
  for (const std::size_t pieces : {1u, 2u, 3u, 7u}) {
    expect_own_derivatives<TypeParam>(pieces, {});
    expect_own_derivatives<TypeParam>(pieces, {.start = Eigen::Vector3d(1.0, 2.0, 3.0)});
    expect_own_derivatives<TypeParam>(pieces, {.end = Eigen::Vector3d(1.0, 2.0, 3.0)});
    if (pieces > 1) expect_own_derivatives<TypeParam>(pieces, {.closed = true});
  }
  expect_own_derivatives<TypeParam>(8, {.closed = true});  // two keys more than the last whole three
}

TEST(ChartAcceleration, IsTheDerivativeOfTheBodyRate) {
  Dice dice(89);
  for (const double angle : {0.0, 1e-6, 0.4, 1.99, 2.01, 3.0, 3.99, 4.01, 6.0}) {
    SCOPED_TRACE(angle);
    const Eigen::Vector3d p = angle * dice.vector().normalized(), velocity = dice.vector(),
                          acceleration = dice.vector();
    const Eigen::Vector3d wanted = body_rates(p, {velocity, acceleration, Eigen::Vector3d::Zero()})[1];
    EXPECT_TRUE(near(ChartAcceleration(p)(velocity, acceleration), wanted, tolerance::algebra));
  }
}

}}  // namespace orispline
