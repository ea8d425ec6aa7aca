// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least/minimisation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Cholesky>

#include <orispline/math/chain_elimination.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr int unknowns = 9;                            // of a node: turn, ω and α
constexpr int first_steps = 4, most_first_steps = 60;  // of Gauss and Newton, before and after what they gain is asked
constexpr double contraction = 0.3;                    // of their steps, that tells that they converge soon
constexpr int most_newton_steps = 150, most_trials = 400;
constexpr double energy_rounding = 1e-12;  // an energy that rises by no more than this share has not risen
constexpr double step_rounding = 1e-12;    // [rad]; shorter steps are made whatever they do to the energy
constexpr double step_floor = 1e-14;       // [rad]; a next step as short, at the present pace, is left out
constexpr double first_damping = 1e-4, least_damping = 1e-7, most_damping = 1e10;
constexpr double longest_step = 4.0;        // [rad]
constexpr double longest_flat_step = 1e-3;  // [rad]; such a step that gains no more than rounding is the last one
constexpr double flat_gain = 1e-9;   // of the energy, whose rounding is as large where many turns take short times
constexpr int most_flat_steps = 10;  // that gain no more than that, one after the other, and have not converged
constexpr double poor_gain = 0.25, good_gain = 0.75;  // of what a step should gain: more or less damping

using Block = Eigen::Matrix<double, unknowns, unknowns>;
using Move = Eigen::Matrix<double, unknowns, 1>;

/// How the nodes are to be moved: turns as q exp(x), ω and α by sums.
struct LeastStep {
  std::vector<Move> nodes{};
  double size = 0.0;       ///< largest change of a node, its rates times powers of its shorter piece [rad]
  std::size_t widest = 0;  ///< the node that has it

  LeastStep() = default;
  LeastStep(const LeastProblem& problem, std::vector<Move> moves) : nodes(std::move(moves)) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double h = problem.shorter_piece_beside(i);
      const double change =
          nodes[i].head<3>().norm() + h * nodes[i].segment<3>(3).norm() + h * h * nodes[i].tail<3>().norm();
      if (change <= size) continue;  // not where it is NaN, which then stays
      size = change;
      widest = i;
    }
  }
};

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

/// The step of Gauss and Newton from the present nodes, by elimination from node to node.
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

/// The equations of Newton's method with all second derivatives at the present nodes, damped as by
/// Levenberg and Marquardt: symmetric, with a block for each node and one to the next.
class LeastNewton {
 public:
  template <LeastOf F>
  [[nodiscard]] static LeastNewton at(const LeastProblem& problem);

  struct Step {
    LeastStep step;
    double gain;  ///< by which the energy would fall if it were of second order
  };
  /// Absent where the damped Hessian is not positive definite.
  [[nodiscard]] std::optional<Step> step(const LeastProblem& problem, double damping) const;

 private:
  std::vector<Block> blocks_{}, links_{};
  std::vector<Move> sides_{};
  std::vector<Eigen::Array3d> weights_{};
};

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

template <LeastOf F>
double energy(const LeastProblem& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.durations.size(); ++i)
    sum += LeastElement<F>::residual(p.increment_after(i), p.nodes[i].rates, p.nodes[i + 1].rates, p.durations[i],
                                     p.inertia)
               .squaredNorm();
  return sum;
}

void move(LeastProblem& problem, const LeastStep& step) {
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    LeastNode& node = problem.nodes[i];
    if (!problem.fixed[i].test(0))
      node.orientation = (node.orientation * exp<double>(step.nodes[i].head<3>())).normalized();
    node.rates += step.nodes[i].tail<6>();
  }
}

/// Tells when steps without damping have come to rounding.
class Ending {
 public:
  /// Whether a step of that size is the last one.
  [[nodiscard]] static bool is_exact(double size, const LeastOutcome& before) {
    return size < least_tolerance && size * size < step_floor * before.last_step;
  }
  /// Whether steps get no shorter any more: the nodes before this one are the better ones.
  [[nodiscard]] static bool is_rounding(double size, const LeastOutcome& before) {
    return size < least_tolerance && before.converged && !(size < before.last_step);
  }
};

/// Steps of Gauss and Newton while they get shorter soon, and lower the energy.
template <LeastOf F>
LeastOutcome first_steps_of(LeastProblem& problem, double& now) {
  LeastOutcome outcome{.converged = false, .last_step = std::numeric_limits<double>::infinity(), .widest = 0};
  for (int i = 0; i < most_first_steps && std::isfinite(now); ++i) {
    const LeastStep step = gauss_newton_step<F>(problem);
    if (Ending::is_rounding(step.size, outcome)) break;
    const bool slow = i >= first_steps && !(step.size < contraction * outcome.last_step);
    if ((slow && !(step.size < least_tolerance)) || !(step.size < longest_step)) return outcome;
    std::vector<LeastNode> before = problem.nodes;
    move(problem, step);
    const double there = energy<F>(problem);
    if (!(there <= now * (1.0 + energy_rounding) || step.size < step_rounding)) {
      problem.nodes = std::move(before);
      return outcome;
    }
    const bool exact = Ending::is_exact(step.size, outcome);
    now = there;
    outcome = {.converged = step.size < least_tolerance, .last_step = step.size, .widest = step.widest};
    if (exact) break;
  }
  return outcome;
}

/// Newton's method in a region of trust: damped where the Hessian is not positive definite, where a step is long, and
/// where it gains less than the Hessian says.
template <LeastOf F>
LeastOutcome newton_steps_of(LeastProblem& problem, double now) {
  LeastOutcome outcome{.converged = false, .last_step = std::numeric_limits<double>::infinity(), .widest = 0};
  double damping = 0.0;
  int trials = 0, flat = 0;
  for (int i = 0; i < most_newton_steps && flat < most_flat_steps && std::isfinite(now); ++i) {
    const auto equations = LeastNewton::at<F>(problem);
    const std::vector<LeastNode> before = problem.nodes;
    while (true) {
      if (++trials > most_trials || damping > most_damping) return outcome;
      const auto trial = equations.step(problem, damping);
      if (trial && Ending::is_rounding(trial->step.size, outcome) && damping == 0.0) return outcome;
      if (trial && trial->step.size < longest_step) {
        move(problem, trial->step);
        const double there = energy<F>(problem), share = (now - there) / trial->gain;
        const bool tiny = trial->step.size < step_rounding || trial->gain < energy_rounding * now;
        if (share > 0.01 || (tiny && there <= now * (1.0 + energy_rounding)) || trial->step.size < step_rounding) {
          const bool stalled = trial->gain < energy_rounding * now && trial->step.size < longest_flat_step &&
                               !(2.0 * trial->step.size < outcome.last_step);  // of long turns, by their rounding
          const bool settled = damping == 0.0 && (trial->step.size < least_tolerance || stalled);
          const bool exact = settled && (stalled || Ending::is_exact(trial->step.size, outcome));
          flat = trial->gain < flat_gain * now ? flat + 1 : 0;
          now = there;
          outcome = {.converged = settled, .last_step = trial->step.size, .widest = trial->step.widest};
          if (exact) return outcome;
          if (share < poor_gain && !tiny) damping = std::max(2.0 * damping, first_damping);
          else if (share > good_gain || tiny) damping = damping > least_damping ? 0.125 * damping : 0.0;
          break;
        }
        problem.nodes = before;
        if (trial->gain < flat_gain * now)
          if (const auto whole = equations.step(problem, 0.0);
              whole && whole->step.size < longest_flat_step && whole->gain < flat_gain * now)
            return {.converged = true, .last_step = whole->step.size, .widest = whole->step.widest};
      }
      damping = std::max(4.0 * damping, first_damping);
    }
  }
  return outcome;
}

template <LeastOf F>
LeastOutcome minimised(LeastProblem& problem) {
  double now = energy<F>(problem);
  const LeastOutcome outcome = first_steps_of<F>(problem, now);
  if (outcome.converged) return outcome;
  LeastOutcome by_newton = newton_steps_of<F>(problem, now);
  by_newton.easy = false;
  return by_newton;
}

/// Calls `use` with the energy as a type.
template <class Use>
auto with_energy(LeastOf of, Use use) {
  switch (of) {
    case LeastOf::torque:
      return use.template operator()<LeastOf::torque>();
    case LeastOf::jerk:
      return use.template operator()<LeastOf::jerk>();
    default:
      return use.template operator()<LeastOf::acceleration>();
  }
}

}  // namespace

double energy_of(const LeastProblem& problem) {
  return with_energy(problem.of, [&]<LeastOf F>() { return energy<F>(problem); });
}

LeastOutcome minimise(LeastProblem& problem) {
  return with_energy(problem.of, [&]<LeastOf F>() { return minimised<F>(problem); });
}

}}}  // namespace orispline::families
