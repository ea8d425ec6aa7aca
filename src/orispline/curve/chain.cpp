// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/chain.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

namespace orispline::chain {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SparseLU<Matrix, Eigen::NaturalOrdering<int>>;

Outcome largest(const Steps& residual) {
  Outcome outcome{0.0, 0};
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const double size = residual[i].norm();
    if (!(size <= outcome.residual)) outcome = {size, i};  // a NaN is the largest of all
  }
  return outcome;
}

Eigen::VectorXd stacked(const Steps& v) {
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(v.size()));
  for (std::size_t i = 0; i < v.size(); ++i) x.segment<3>(3 * static_cast<Eigen::Index>(i)) = v[i];
  return x;
}

Steps unstacked(const Eigen::VectorXd& x, double scale) {
  Steps v(static_cast<std::size_t>(x.size()) / 3);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = scale * x.segment<3>(3 * static_cast<Eigen::Index>(i));
  return v;
}

/// Unknowns of one colour share no equation, so that one pass over jets differentiates by all of them at once.
std::vector<std::size_t> colours(const Equations& e) {
  std::vector<std::size_t> colour(e.size);
  for (std::size_t i = 0; i < e.size; ++i) colour[i] = i % 3;
  const std::size_t beyond = e.closed ? e.size % 3 : 0;  // where the row of three does not close
  for (std::size_t k = 0; k < beyond; ++k) colour[e.size - 1 - k] = 3 + k;
  return colour;
}

/// The equations that unknown i enters.
std::vector<std::size_t> touched(const Equations& e, std::size_t i) {
  std::vector<std::size_t> all{i};
  if (i > 0 || e.closed) all.push_back((i + e.size - 1) % e.size);
  if (i + 1 < e.size || e.closed) all.push_back((i + 1) % e.size);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Matrix jacobian(const Equations& e) {
  const std::vector<std::size_t> colour = colours(e);
  const std::size_t colour_count = 1 + *std::ranges::max_element(colour);
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(27 * e.size);
  for (std::size_t c = 0; c < colour_count; ++c)
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      JetSteps steps(e.size, Vector3<Jet<double, 1>>::Constant(Jet<double, 1>(0.0)));
      for (std::size_t i = 0; i < e.size; ++i)
        if (colour[i] == c) steps[i][axis] = Jet<double, 1>::variable(0.0);
      const JetSteps residual = e.derivative(steps);
      for (std::size_t i = 0; i < e.size; ++i)
        if (colour[i] == c)
          for (const std::size_t row : touched(e, i))
            for (Eigen::Index k = 0; k < 3; ++k)
              entries.emplace_back(static_cast<int>(3 * row) + static_cast<int>(k),
                                   static_cast<int>(3 * i) + static_cast<int>(axis), residual[row][k].c[1]);
    }
  const auto size = static_cast<Eigen::Index>(3 * e.size);
  Matrix j(size, size);
  j.setFromTriplets(entries.begin(), entries.end());
  return j;
}

/// Halves the step until the residual falls; moves there. False when it does not.
bool descend(const Equations& e, const Eigen::VectorXd& step, Steps& residual, Outcome& now) {
  for (double share = 1.0; share > 1e-4; share *= 0.5) {
    const Steps steps = unstacked(step, share);
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
  Solver solver;
  int age = 0;  // steps taken with the present Jacobian, 0 when it is to be formed
  for (int i = 0; i < newton_steps && now.residual > 0.0; ++i) {
    if (age == 0) solver.compute(jacobian(e));
    if (solver.info() != Eigen::Success) return now.solved();
    const Outcome before = now;
    if (!descend(e, solver.solve(-stacked(residual)), residual, now)) {
      if (before.solved() || age == 0) return before.solved();
      age = 0;
      continue;
    }
    if (before.solved() && now.residual > 0.25 * before.residual) return true;
    age = now.residual > 0.1 * before.residual ? 0 : age + 1;
  }
  return now.solved();
}

void marquardt(const Equations& e, Steps& residual, Outcome& now) {
  double damping = 1e-3;
  Solver solver;
  for (int i = 0; i < marquardt_steps && now.residual > 1e-9; ++i) {
    const Matrix j = jacobian(e);
    const Matrix normal = j.transpose() * j;
    const Eigen::VectorXd gradient = j.transpose() * stacked(residual);
    const double before = stacked(residual).squaredNorm();
    double after = before;
    bool better = false;
    for (; !better && damping < 1e12; damping *= better ? 0.1 : 4.0) {
      Matrix damped = normal;
      for (Eigen::Index k = 0; k < damped.rows(); ++k) damped.coeffRef(k, k) += damping * (1.0 + normal.coeff(k, k));
      solver.compute(damped);
      if (solver.info() != Eigen::Success) continue;
      const Steps steps = unstacked(solver.solve(-gradient), 1.0);
      Steps there = e.residual(steps);
      after = stacked(there).squaredNorm();
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
                                ? std::string("its equations hold only for a curve that winds round")
                                : fmt::format("the residual stays at {:.3g}, wanted {:g}", outcome.residual, tolerance);
  const std::string nearer = share > 0.0 ? fmt::format("it does for increments of {:.2g} times their length", share)
                                         : std::string("nor does it for shorter increments");
  return {ErrorCode::not_converged,
          fmt::format("{} does not converge for these keys: {}; {}", method, found, nearer),
          {.key = outcome.worst}};
}

}  // namespace orispline::chain
