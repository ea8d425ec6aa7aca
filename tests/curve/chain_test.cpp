// SPDX-License-Identifier: Apache-2.0
// Chains of equations: solved with any size, open and closed; where there is no solution the worst equation is named.
#include <gtest/gtest.h>

#include <orispline/curve/chain.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

enum class Shape { open, closed };

/// Equations f(x) = f(x*) whose solution x* is known: neighbours enter with weight one, or not linearly at all.
class KnownChain {
 public:
  KnownChain(std::vector<Eigen::Vector3d> solution, Shape shape, double nonlinear)
      : solution_(std::move(solution)),
        state_(solution_.size(), Eigen::Vector3d::Zero()),
        shape_(shape),
        nonlinear_(nonlinear) {}

  [[nodiscard]] std::size_t size() const { return solution_.size(); }
  [[nodiscard]] bool closed() const { return shape_ == Shape::closed; }
  [[nodiscard]] bool plausible() const { return true; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& state() const { return state_; }
  void move(std::span<const Eigen::Vector3d> by) {
    for (std::size_t i = 0; i < by.size(); ++i) state_[i] += by[i];
  }

  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> moved_by) const {
    std::vector<Vector3<T>> here, wanted, residual;
    for (std::size_t i = 0; i < size(); ++i) {
      here.push_back(constant<T>(state_[i]) + moved_by[i]);
      wanted.push_back(constant<T>(solution_[i]));
    }
    for (std::size_t i = 0; i < size(); ++i) residual.push_back(value<T>(i, here) - value<T>(i, wanted));
    return residual;
  }

 private:
  template <Number T>
  [[nodiscard]] Vector3<T> value(std::size_t i, const std::vector<Vector3<T>>& x) const {
    Vector3<T> sum = x[i] * T(4.0) + x[i] * (x[i].squaredNorm() * T(nonlinear_));
    if (i > 0 || closed()) sum += neighbour<T>(x[i], x[(i + size() - 1) % size()]);
    if (i + 1 < size() || closed()) sum += neighbour<T>(x[i], x[(i + 1) % size()]);
    return sum;
  }
  template <Number T>
  [[nodiscard]] Vector3<T> neighbour(const Vector3<T>& x, const Vector3<T>& y) const {
    return y + x.cross(y) * T(nonlinear_);
  }

  std::vector<Eigen::Vector3d> solution_, state_;
  Shape shape_;
  double nonlinear_;
};

static_assert(ChainProblem<KnownChain>);

std::vector<Eigen::Vector3d> some_vectors(std::size_t count) {
  Dice dice(261);
  std::vector<Eigen::Vector3d> vectors;
  for (std::size_t i = 0; i < count; ++i) vectors.push_back(dice.vector());
  return vectors;
}

void expect_solved(std::size_t size, Shape shape, double nonlinear) {
  const std::vector<Eigen::Vector3d> solution = some_vectors(size);
  KnownChain chain(solution, shape, nonlinear);
  const chain::Outcome outcome = chain::solve(chain);
  EXPECT_TRUE(outcome.solved()) << outcome.residual;
  EXPECT_LT(outcome.worst, size);
  for (std::size_t i = 0; i < size; ++i) EXPECT_TRUE(near(chain.state()[i], solution[i], tolerance::series)) << i;
}

TEST(Chain, SolvesLinearEquationsOfAnySizeOpenAndClosed) {
  for (const Shape shape : {Shape::open, Shape::closed})
    for (const std::size_t size : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 50u}) {
      SCOPED_TRACE(testing::Message() << size << (shape == Shape::open ? " open" : " closed"));
      expect_solved(size, shape, 0.0);
    }
}

TEST(Chain, SolvesNonlinearEquationsOfAnySizeOpenAndClosed) {
  for (const Shape shape : {Shape::open, Shape::closed})
    for (const std::size_t size : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 50u}) {
      SCOPED_TRACE(testing::Message() << size << (shape == Shape::open ? " open" : " closed"));
      expect_solved(size, shape, 0.3);
    }
}

TEST(Chain, SaysThatASolvedStateIsSolvedAndLeavesItThere) {
  KnownChain chain(std::vector(3, Eigen::Vector3d(0.0, 0.0, 0.0)), Shape::open, 0.3);
  EXPECT_EQ(chain::solve(chain).residual, 0.0);
  for (const Eigen::Vector3d& x : chain.state()) EXPECT_EQ(x, Eigen::Vector3d::Zero());
}

/// x = share at every place, up to a share beyond which one of the equations, x² + 1 = 0, has no solution.
struct BreakingChain {
  double share = 1.0, solvable_to = 0.0;
  std::size_t broken = 0;
  double started_at = 0.0;
  double tame_to = 1.0;  ///< an implausible solution beyond, unless it was come to from a nearer one
  std::vector<Eigen::Vector3d> state = std::vector(5, Eigen::Vector3d(0.3, 0.3, 0.3));

  [[nodiscard]] std::size_t size() const { return state.size(); }
  [[nodiscard]] bool closed() const { return false; }
  [[nodiscard]] bool plausible() const { return share - started_at <= tame_to; }
  void move(std::span<const Eigen::Vector3d> by) {
    for (std::size_t i = 0; i < by.size(); ++i) state[i] += by[i];
  }
  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> moved_by) const {
    std::vector<Vector3<T>> residual;
    for (std::size_t i = 0; i < size(); ++i) {
      const Vector3<T> x = constant<T>(state[i]) + moved_by[i];
      if (i == broken && share > solvable_to) residual.push_back(x.cwiseProduct(x) + Vector3<T>::Constant(T(1.0)));
      else residual.push_back(x - Vector3<T>::Constant(T(share)));
    }
    return residual;
  }
};

TEST(Chain, NamesTheEquationThatHasNoSolution) {
  for (const std::size_t broken : {0u, 2u, 4u}) {
    BreakingChain chain{.broken = broken};
    const chain::Outcome outcome = chain::solve(chain);
    EXPECT_FALSE(outcome.solved());
    EXPECT_EQ(outcome.worst, broken);
    EXPECT_GE(outcome.residual, 1.0);
    EXPECT_LE(outcome.residual, std::sqrt(3.0) * (1.0 + 0.3 * 0.3));  // not worse than where it began
  }
}

TEST(Chain, GivesUpSoonWhereNothingMoreIsToBeGained) {
  BreakingChain chain;
  std::size_t jacobians = 0;
  const chain::Outcome outcome = chain::solve(
      chain::Equations{.size = chain.size(),
                       .closed = false,
                       .residual = [&](const chain::Steps& steps) { return chain.residual<double>(steps); },
                       .jacobian =
                           [&](const chain::TakeBlock& take) {
                             ++jacobians;
                             chain::differentiate(chain, take);
                           },
                       .move = [&](const chain::Steps& steps) { chain.move(steps); }});
  EXPECT_FALSE(outcome.solved());
  EXPECT_LE(jacobians, 30u);
}

TEST(Chain, IsRefusedWithKeyResidualAndTheShareThatWasReached) {
  const auto solved = solve_chain("some-method", [](double share, const BreakingChain*) {
    return BreakingChain{.share = share, .solvable_to = 0.6, .broken = 3};
  });
  ASSERT_FALSE(solved);
  EXPECT_EQ(solved.error().code, ErrorCode::not_converged);
  EXPECT_EQ(solved.error().where.key, 3u);
  const std::string& message = solved.error().message;
  EXPECT_TRUE(message.starts_with("some-method does not converge for these keys: the residual stays at 1.")) << message;
  EXPECT_TRUE(
      message.ends_with(", wanted 1e-12; it converges where every step turns 0.6 times as far; put keys in between, or "
                        "take a local method such as timed-c2"))
      << message;
}

TEST(Chain, GoesOnFromNearerKeysWhereTheDirectSolutionIsNotPlausible) {
  int problems = 0;
  const auto solved = solve_chain("some-method", [&](double share, const BreakingChain* before) {
    ++problems;
    BreakingChain chain{.share = share, .solvable_to = 1.0, .tame_to = 0.2};
    if (before) {
      EXPECT_LT(before->share, share);
      EXPECT_TRUE(before->plausible());
      chain.started_at = before->share;
      chain.state = before->state;
    }
    return chain;
  });
  ASSERT_TRUE(solved) << describe(solved.error());
  EXPECT_EQ(solved->share, 1.0);
  EXPECT_GE(solved->started_at, 0.8);
  EXPECT_GT(problems, 6);
  for (const Eigen::Vector3d& x : solved->state) EXPECT_TRUE(near(x, Eigen::Vector3d(1, 1, 1), tolerance::series));
}

TEST(Chain, IsRefusedWhereEverySolutionWindsRound) {
  const auto solved = solve_chain("some-method", [](double share, const BreakingChain*) {
    return BreakingChain{.share = share, .solvable_to = 1.0, .tame_to = 0.5};
  });
  ASSERT_FALSE(solved);
  EXPECT_EQ(solved.error().code, ErrorCode::not_converged);
  EXPECT_EQ(solved.error().message,
            "some-method does not converge for these keys: its equations hold only for a curve that winds round once "
            "more; it converges where every step turns 0.5 times as far; put keys in between, or take a local method "
            "such as timed-c2");
}

TEST(Chain, ToldNotANumberIsNotSolved) {
  KnownChain chain({Eigen::Vector3d(1, 2, 3), Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()),
                    Eigen::Vector3d(1, 0, 0)},
                   Shape::open, 0.0);
  EXPECT_FALSE(chain::solve(chain).solved());
}

}}  // namespace orispline
