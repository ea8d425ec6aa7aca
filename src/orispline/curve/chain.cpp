// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/chain.hpp>

#include <algorithm>
#include <optional>

#include <orispline/base/formatted.hpp>
#include <orispline/math/banded_lu.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace chain {

namespace {

Outcome largest(const Steps& residual) {
  Outcome outcome{0.0, 0};
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const double size = residual[i].norm();
    if (!(size <= outcome.residual)) outcome = {size, i};  // a NaN is the largest of all
  }
  return outcome;
}

/// Where an unknown and its equation stand in the matrix: a loop is folded into a row of its two halves, so that its
/// first and last are neighbours there too.
std::size_t place(const Equations& e, std::size_t i) {
  if (!e.closed) return i;
  const std::size_t back = e.size - 1 - i;
  return i <= back ? 2 * i : 2 * back + 1;
}

/// How far from the diagonal the blocks of neighbours reach.
std::size_t band(const Equations& e) { return 3 * (e.closed ? 2 : 1) + 2; }

Eigen::VectorXd stacked(const Equations& e, const Steps& v) {
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(v.size()));
  for (std::size_t i = 0; i < v.size(); ++i) x.segment<3>(3 * static_cast<Eigen::Index>(place(e, i))) = v[i];
  return x;
}

Steps unstacked(const Equations& e, const Eigen::VectorXd& x, double scale) {
  Steps v(e.size);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = scale * x.segment<3>(3 * static_cast<Eigen::Index>(place(e, i)));
  return v;
}

BandedMatrix jacobian(const Equations& e) {
  BandedMatrix j(3 * e.size, band(e));
  e.jacobian([&](std::size_t equation, std::size_t unknown, const Eigen::Matrix3d& block) {
    j.add(3 * place(e, equation), 3 * place(e, unknown), block);
  });
  return j;
}

/// Halves the step until the residual falls; moves there. False when it does not. Where the equations are solved it is
/// rounding that keeps it from falling, and no shorter step is tried.
bool descend(const Equations& e, const Eigen::VectorXd& step, Steps& residual, Outcome& now) {
  for (double share = 1.0; share > (now.solved() ? 0.5 : 1e-4); share *= 0.5) {
    const Steps steps = unstacked(e, step, share);
    Steps there = e.residual(steps);
    const Outcome then = largest(there);
    if (!(then.residual < now.residual)) continue;
    e.move(steps);
    residual = std::move(there);
    now = then;
    return true;
  }
  return false;
}

constexpr int newton_steps = 60, marquardt_steps = 80;
/// A step that leaves more than that of the sum of squares goes nowhere.
constexpr double nothing_gained = 0.999;

/// True when it has come as near as rounding lets it.
bool newton(const Equations& e, Steps& residual, Outcome& now) {
  std::optional<BandedLu> solver;  // absent when the Jacobian is to be formed
  for (int i = 0; i < newton_steps && now.residual > 0.0; ++i) {
    const bool fresh = !solver;
    if (fresh) solver.emplace(jacobian(e));
    if (!solver->regular()) return now.solved();
    const Outcome before = now;
    if (!descend(e, solver->solve(-stacked(e, residual)), residual, now)) {
      if (before.solved() || fresh) return before.solved();
      solver.reset();
      continue;
    }
    if (before.solved() && now.residual > 0.25 * before.residual) return true;
    if (now.residual > 0.1 * before.residual) solver.reset();
  }
  return now.solved();
}

void marquardt(const Equations& e, Steps& residual, Outcome& now) {
  double damping = 1e-3;
  for (int i = 0; i < marquardt_steps && now.residual > 1e-9; ++i) {
    const BandedMatrix j = jacobian(e), normal = normal_matrix(j);
    const Eigen::VectorXd gradient = transposed_product(j, stacked(e, residual));
    const double before = stacked(e, residual).squaredNorm();
    double after = before;
    bool better = false;
    for (; !better && damping < 1e12; damping *= better ? 0.1 : 4.0) {
      BandedMatrix damped = normal;
      for (std::size_t k = 0; k < damped.size(); ++k) damped(k, k) += damping * (1.0 + normal(k, k));
      const BandedLu solver(std::move(damped));
      if (!solver.regular()) continue;
      const Steps steps = unstacked(e, solver.solve(-gradient), 1.0);
      Steps there = e.residual(steps);
      after = stacked(e, there).squaredNorm();
      better = after < before;
      if (!better) continue;
      e.move(steps);
      now = largest(there);
      residual = std::move(there);
    }
    if (!better || after > nothing_gained * before) return;
  }
}

}  // namespace

Outcome solve(const Equations& equations) {
  Steps residual = equations.residual(Steps(equations.size, Eigen::Vector3d::Zero()));
  Outcome now = largest(residual);
  if (newton(equations, residual, now)) return now;
  marquardt(equations, residual, now);
  if (newton(equations, residual, now)) return now;
  return now;
}

Error not_converged(std::string_view method, const Outcome& outcome, double share) {
  const std::string found = outcome.solved()
                                ? std::string("its equations hold only for a curve that winds round once more")
                                : formatted("the residual stays at {:.3g}, wanted {:g}", outcome.residual, tolerance);
  const std::string nearer = share > 0.0 ? formatted(
                                               "it converges where every step turns {:.2g} times as far; put keys in "
                                               "between, or take a local method such as timed-c2",
                                               share)
                                         : std::string(
                                               "it does not converge for shorter steps either; put keys in between, or "
                                               "take a local method such as timed-c2");
  return {ErrorCode::not_converged,
          formatted("{} does not converge for these keys: {}; {}", method, found, nearer),
          {.key = outcome.worst}};
}

}}}  // namespace orispline::chain
