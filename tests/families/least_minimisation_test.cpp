// SPDX-License-Identifier: Apache-2.0
// The iteration of the curves of least energy beside steps of Gauss and Newton by dense linear algebra.
#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <orispline/families/least/minimisation.hpp>
#include <support/specimens.hpp>

namespace orispline::families { namespace {

using testing_support::Dice;

/// Pieces of the least jerk between two or three keys, with rates at random where the iteration begins.
LeastProblem any_problem(std::uint64_t seed) {
  constexpr std::size_t pieces = 3;  // between two keys
  Dice dice(seed);
  const std::size_t keys = 2 + seed % 2;
  const double turn = 1.0 + 0.5 * static_cast<double>(seed % 5), wild = 0.3 * static_cast<double>(seed % 4);
  LeastProblem problem{.of = LeastOf::jerk};
  Eigen::Quaterniond key = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < keys; ++i) {
    const Eigen::Vector3d step = turn * dice.vector();
    const double duration = std::exp(dice.between(-1.0, 1.0));
    for (std::size_t k = 0; k < (i + 1 < keys ? pieces : 1); ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(pieces);
      const Eigen::Vector3d aside = k == 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(wild * dice.vector());
      LeastNode& node = problem.nodes.emplace_back();
      node.orientation = (key * exp<double>(Eigen::Vector3d(share * step)) * exp<double>(aside)).normalized();
      node.rates << 2.0 * dice.vector(), 2.0 * dice.vector();
      problem.fixed.emplace_back(k == 0 ? 0b111 : 0);
      if (i + 1 < keys) problem.durations.push_back(duration / static_cast<double>(pieces));
    }
    key = key * exp<double>(step);
  }
  for (auto* end : {&problem.fixed.front(), &problem.fixed.back()}) *end |= 0b111'000;  // their ω too
  return problem;
}

/// Residuals of all pieces, and their slopes by the unknowns of all nodes.
std::pair<Eigen::VectorXd, Eigen::MatrixXd> linearised(const LeastProblem& problem) {
  using Element = LeastElement<LeastOf::jerk>;
  const auto pieces = static_cast<Eigen::Index>(problem.durations.size());
  Eigen::VectorXd residual(Element::rows * pieces);
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(residual.size(), 9 * (pieces + 1));
  for (Eigen::Index i = 0; i < pieces; ++i) {
    const auto piece = static_cast<std::size_t>(i);
    const auto e = Element::linearised(problem.increment_after(piece), problem.nodes[piece].rates,
                                       problem.nodes[piece + 1].rates, problem.durations[piece], problem.inertia);
    residual.segment<Element::rows>(Element::rows * i) = e.residual;
    slopes.block<Element::rows, 18>(Element::rows * i, 9 * i) = e.jacobian;
  }
  for (std::size_t i = 0; i < problem.nodes.size(); ++i)
    for (std::size_t k = 0; k < 9; ++k)
      if (problem.fixed[i].test(k)) slopes.col(static_cast<Eigen::Index>(9 * i + k)).setZero();
  return {residual, slopes};
}

/// A step of Gauss and Newton, and the largest change of a node, as LeastOutcome has it.
double dense_step(LeastProblem& problem) {
  const auto [residual, slopes] = linearised(problem);
  const Eigen::VectorXd step = slopes.completeOrthogonalDecomposition().solve(-residual);
  double largest = 0.0;
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const Eigen::Matrix<double, 9, 1> x = step.segment<9>(static_cast<Eigen::Index>(9 * i));
    const double h = problem.shorter_piece_beside(i);
    problem.nodes[i].orientation =
        (problem.nodes[i].orientation * exp<double>(Eigen::Vector3d(x.head<3>()))).normalized();
    problem.nodes[i].rates += x.tail<6>();
    largest = std::max(largest, x.head<3>().norm() + h * x.segment<3>(3).norm() + h * h * x.tail<3>().norm());
  }
  return largest;
}

/// Where the largest of the slopes of the energy by the unknowns is 0, in units of what its parts are.
double steepness(const LeastProblem& problem) {
  const auto [residual, slopes] = linearised(problem);
  return (slopes.transpose() * residual).norm() / (slopes.norm() * residual.norm());
}

TEST(LeastMinimisation, TakesAStepOfGaussAndNewtonBackThatRaisesTheEnergy) {
  for (const std::uint64_t seed : {148u, 258u, 558u, 1402u, 2524u}) {
    LeastProblem path = any_problem(seed), problem = path;
    double lowest = energy_of(path), largest_step = dense_step(path);
    for (int k = 1; k < 4 && energy_of(path) <= lowest; ++k) {
      lowest = energy_of(path);
      largest_step = std::max(largest_step, dense_step(path));
    }
    ASSERT_GT(energy_of(path), 1.01 * lowest) << seed;
    ASSERT_LT(largest_step, 4.0) << seed;  // longer ones are not tried
    const LeastOutcome outcome = minimise(problem);
    EXPECT_TRUE(outcome.converged) << seed;
    EXPECT_FALSE(outcome.easy) << seed;
    EXPECT_LT(energy_of(problem), lowest) << seed;
    EXPECT_LT(steepness(problem), 1e-8) << seed;
  }
}

TEST(LeastMinimisation, NeedsNoMoreThanStepsOfGaussAndNewtonThatLowerTheEnergySoon) {
  std::size_t easy = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    LeastProblem path = any_problem(seed), problem = path;
    double before = energy_of(path), size = 4.0;
    bool falls_soon = true;
    for (int k = 0; falls_soon && size > 1e-7; ++k) {
      const double next = dense_step(path);
      falls_soon = energy_of(path) < before && next < (k < 4 ? 4.0 : 0.25 * size);
      before = energy_of(path);
      size = next;
    }
    if (!falls_soon) continue;
    ++easy;
    const LeastOutcome outcome = minimise(problem);
    EXPECT_TRUE(outcome.converged && outcome.easy) << seed;
    EXPECT_NEAR(energy_of(problem) / before, 1.0, 1e-9) << seed;
    EXPECT_LT(steepness(problem), 1e-8) << seed;
    problem.nodes[1].rates[0] += 1e-8;  // back to it at once, though its energy no longer falls but for rounding
    const LeastOutcome again = minimise(problem);
    EXPECT_TRUE(again.converged && again.easy) << seed;
  }
  EXPECT_GT(easy, 10u);
}

}}  // namespace orispline::families
