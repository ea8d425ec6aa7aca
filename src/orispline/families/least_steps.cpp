// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <Eigen/Cholesky>

#include <orispline/families/least_problem.hpp>
#include <orispline/math/chain_elimination.hpp>

namespace orispline::inline ORISPLINE_ABI::families {
namespace {

constexpr int unknowns = 9;
using Block = Eigen::Matrix<double, unknowns, unknowns>;
using Move = Eigen::Matrix<double, unknowns, 1>;

template <LeastOf F>
auto linearised(const LeastProblem& p, std::size_t i) {
  return LeastElement<F>::linearised(p.increment_after(i), p.nodes[i].rates, p.nodes[i + 1].rates, p.durations[i],
                                     p.inertia);
}

/// By as many rows of damping for each node.
template <LeastOf F, int Damping>
LeastStep eliminated(const LeastProblem& problem, double damping) {
  constexpr int rows = LeastElement<F>::rows;
  using Chain = ChainElimination<unknowns, Damping, 1, rows>;
  const std::size_t last = problem.durations.size();
  Chain chain;
  chain.start(last + 1);
  Eigen::Array3d before = Eigen::Array3d::Zero();
  for (std::size_t i = 0; i <= last; ++i) {
    typename Chain::Low low = Chain::Low::Zero();
    auto link = low.template bottomRows<rows>();
    if (i < last) {
      const auto e = linearised<F>(problem, i);
      link.template leftCols<2 * unknowns>() = e.jacobian;
      link.template rightCols<1>() = -e.residual;
    }
    if constexpr (Damping > 0) {
      const Eigen::Array3d weights = before + damping_weights(link);
      for (int k = 0; k < unknowns; ++k) low(k, k) = std::sqrt(damping * weights[k / 3]);
      before = damping_weights(link.template middleCols<unknowns>(unknowns));
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

/// Rows and columns of unknowns that stay as they are.
void strike_out(Block& block, const std::bitset<unknowns>& rows, const std::bitset<unknowns>& columns) {
  for (int k = 0; k < unknowns; ++k) {
    if (rows.test(static_cast<std::size_t>(k))) block.row(k).setZero();
    if (columns.test(static_cast<std::size_t>(k))) block.col(k).setZero();
  }
}

/// The equations of Newton's method: symmetric, with a block for each node and one to the next.
struct NewtonEquations {
  std::vector<Block> blocks, links;
  std::vector<Move> sides;
};

template <LeastOf F>
NewtonEquations newton_equations(const LeastProblem& p, double damping) {
  const std::size_t last = p.durations.size();
  NewtonEquations e{std::vector<Block>(last + 1, Block::Zero()), std::vector<Block>(last),
                    std::vector<Move>(last + 1, Move::Zero())};
  const auto damp = [&](std::size_t i, const Eigen::Array3d& weights) {
    for (int k = 0; k < unknowns; ++k) e.blocks[i](k, k) += damping * weights[k / 3];
  };
  for (std::size_t i = 0; i < last; ++i) {
    const auto curved = LeastElement<F>::curved(p.increment_after(i), p.nodes[i].rates, p.nodes[i + 1].rates,
                                                p.durations[i], p.inertia);
    e.blocks[i] += curved.hessian.template topLeftCorner<unknowns, unknowns>();
    e.blocks[i + 1] += curved.hessian.template bottomRightCorner<unknowns, unknowns>();
    e.links[i] = curved.hessian.template topRightCorner<unknowns, unknowns>();
    e.sides[i] -= curved.gradient.template head<unknowns>();
    e.sides[i + 1] -= curved.gradient.template tail<unknowns>();
    if (!(damping > 0.0)) continue;
    const auto jacobian = linearised<F>(p, i).jacobian;
    damp(i, damping_weights(jacobian.template leftCols<unknowns>()));
    damp(i + 1, damping_weights(jacobian.template rightCols<unknowns>()));
  }
  for (std::size_t i = 0; i <= last; ++i) {
    strike_out(e.blocks[i], p.fixed[i], p.fixed[i]);
    if (i < last) strike_out(e.links[i], p.fixed[i], p.fixed[i + 1]);
    for (int k = 0; k < unknowns; ++k)
      if (p.fixed[i].test(static_cast<std::size_t>(k))) {
        e.blocks[i](k, k) = 1.0;
        e.sides[i][k] = 0.0;
      }
  }
  return e;
}

}  // namespace

template <LeastOf F>
LeastStep gauss_newton_step(const LeastProblem& problem, double damping) {
  return damping > 0.0 ? eliminated<F, unknowns>(problem, damping) : eliminated<F, 0>(problem, 0.0);
}

template <LeastOf F>
std::optional<LeastStep> newton_step(const LeastProblem& problem, double damping) {
  NewtonEquations e = newton_equations<F>(problem, damping);
  const std::size_t last = e.links.size();
  std::vector<Eigen::LLT<Block>> factors(last + 1);
  for (std::size_t i = 0; i <= last; ++i) {
    if (i > 0) {
      e.blocks[i].noalias() -= e.links[i - 1].transpose() * e.links[i - 1];
      e.sides[i].noalias() -= e.links[i - 1].transpose() * e.sides[i - 1];
    }
    factors[i].compute(e.blocks[i]);
    if (factors[i].info() != Eigen::Success) return std::nullopt;
    factors[i].matrixL().solveInPlace(e.sides[i]);
    if (i < last) factors[i].matrixL().solveInPlace(e.links[i]);
  }
  for (std::size_t i = last + 1; i-- > 0;) {
    if (i < last) e.sides[i].noalias() -= e.links[i] * e.sides[i + 1];
    factors[i].matrixU().solveInPlace(e.sides[i]);
  }
  return LeastStep(problem, std::move(e.sides));
}

template LeastStep gauss_newton_step<LeastOf::acceleration>(const LeastProblem&, double);
template LeastStep gauss_newton_step<LeastOf::torque>(const LeastProblem&, double);
template LeastStep gauss_newton_step<LeastOf::jerk>(const LeastProblem&, double);
template std::optional<LeastStep> newton_step<LeastOf::acceleration>(const LeastProblem&, double);
template std::optional<LeastStep> newton_step<LeastOf::torque>(const LeastProblem&, double);
template std::optional<LeastStep> newton_step<LeastOf::jerk>(const LeastProblem&, double);

}  // namespace orispline::inline ORISPLINE_ABI::families
