// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <Eigen/Cholesky>

#include <orispline/families/least_problem.hpp>
#include <orispline/math/chain_elimination.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr int unknowns = 9;
using Block = Eigen::Matrix<double, unknowns, unknowns>;
using Move = Eigen::Matrix<double, unknowns, 1>;

template <LeastOf F>
auto linearised(const LeastProblem& p, std::size_t i) {
  return LeastElement<F>::linearised(p.increment_after(i), p.nodes[i].rates, p.nodes[i + 1].rates, p.durations[i],
                                     p.inertia);
}

/// Rows and columns of unknowns that stay as they are.
void strike_out(Block& block, const std::bitset<unknowns>& rows, const std::bitset<unknowns>& columns) {
  for (int k = 0; k < unknowns; ++k) {
    if (rows.test(static_cast<std::size_t>(k))) block.row(k).setZero();
    if (columns.test(static_cast<std::size_t>(k))) block.col(k).setZero();
  }
}

}  // namespace

template <LeastOf F>
LeastStep gauss_newton_step(const LeastProblem& problem) {
  constexpr int rows = LeastElement<F>::rows;
  using Chain = ChainElimination<unknowns, 0, 1, rows>;
  const std::size_t last = problem.durations.size();
  Chain chain;
  chain.start(last + 1);
  for (std::size_t i = 0; i <= last; ++i) {
    typename Chain::Low low = Chain::Low::Zero();
    if (i < last) {
      const auto e = linearised<F>(problem, i);
      low.template leftCols<2 * unknowns>() = e.jacobian;
      low.template rightCols<1>() = -e.residual;
    }
    for (int k = 0; k < unknowns; ++k) {
      const auto unknown = static_cast<std::size_t>(k);
      if (problem.fixed[i].test(unknown)) {
        low.col(k).setZero();
        chain.fix(k);
      }
      if (i < last && problem.fixed[i + 1].test(unknown)) low.col(unknowns + k).setZero();
    }
    static_cast<void>(chain.add(low));
  }
  std::vector<Move> moves(last + 1);
  chain.solve(Eigen::Matrix<double, 1, 1>::Ones(), [&](std::size_t i, const Move& x) { moves[i] = x; });
  return {problem, std::move(moves)};
}

template <LeastOf F>
LeastNewton LeastNewton::at(const LeastProblem& p) {
  const std::size_t last = p.durations.size();
  LeastNewton e;
  e.blocks_.assign(last + 1, Block::Zero());
  e.links_.resize(last);
  e.sides_.assign(last + 1, Move::Zero());
  e.weights_.assign(last + 1, Eigen::Array3d::Zero());
  for (std::size_t i = 0; i < last; ++i) {
    const auto curved = LeastElement<F>::curved(p.increment_after(i), p.nodes[i].rates, p.nodes[i + 1].rates,
                                                p.durations[i], p.inertia);
    e.blocks_[i] += curved.hessian.template topLeftCorner<unknowns, unknowns>();
    e.blocks_[i + 1] += curved.hessian.template bottomRightCorner<unknowns, unknowns>();
    e.links_[i] = curved.hessian.template topRightCorner<unknowns, unknowns>();
    e.sides_[i] -= curved.gradient.template head<unknowns>();
    e.sides_[i + 1] -= curved.gradient.template tail<unknowns>();
    e.weights_[i] += curved.weights[0];
    e.weights_[i + 1] += curved.weights[1];
  }
  for (std::size_t i = 0; i <= last; ++i) {
    strike_out(e.blocks_[i], p.fixed[i], p.fixed[i]);
    if (i < last) strike_out(e.links_[i], p.fixed[i], p.fixed[i + 1]);
    for (int k = 0; k < unknowns; ++k)
      if (p.fixed[i].test(static_cast<std::size_t>(k))) {
        e.blocks_[i](k, k) = 1.0;
        e.sides_[i][k] = 0.0;
      }
  }
  return e;
}

std::optional<LeastNewton::Step> LeastNewton::step(const LeastProblem& problem, double damping) const {
  const std::size_t last = links_.size();
  std::vector<Block> links = links_;
  std::vector<Move> moves = sides_;
  std::vector<Eigen::LLT<Block>> factors(last + 1);
  const auto damped = [&](std::size_t i) {
    Block block = blocks_[i];
    for (int k = 0; k < unknowns; ++k) block(k, k) += damping * weights_[i][k / 3];
    return block;
  };
  for (std::size_t i = 0; i <= last; ++i) {
    Block block = damped(i);
    if (i > 0) {
      block.noalias() -= links[i - 1].transpose() * links[i - 1];
      moves[i].noalias() -= links[i - 1].transpose() * moves[i - 1];
    }
    factors[i].compute(block);
    if (factors[i].info() != Eigen::Success) return std::nullopt;
    factors[i].matrixL().solveInPlace(moves[i]);
    if (i < last) factors[i].matrixL().solveInPlace(links[i]);
  }
  double gain = 0.0;  // with (H + D) x = s, half of x·s + x·D x, twice for the whole energy
  for (std::size_t i = last + 1; i-- > 0;) {
    if (i < last) moves[i].noalias() -= links[i] * moves[i + 1];
    factors[i].matrixU().solveInPlace(moves[i]);
    gain += moves[i].dot(sides_[i]);
    for (int k = 0; k < unknowns; ++k) gain += damping * weights_[i][k / 3] * moves[i][k] * moves[i][k];
  }
  return Step{LeastStep(problem, std::move(moves)), gain};
}

template LeastStep gauss_newton_step<LeastOf::acceleration>(const LeastProblem&);
template LeastStep gauss_newton_step<LeastOf::torque>(const LeastProblem&);
template LeastStep gauss_newton_step<LeastOf::jerk>(const LeastProblem&);
template LeastNewton LeastNewton::at<LeastOf::acceleration>(const LeastProblem&);
template LeastNewton LeastNewton::at<LeastOf::torque>(const LeastProblem&);
template LeastNewton LeastNewton::at<LeastOf::jerk>(const LeastProblem&);

}}}  // namespace orispline::families
