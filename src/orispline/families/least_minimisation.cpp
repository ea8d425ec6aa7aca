// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least_minimisation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline::inline ORISPLINE_ABI::families {
namespace {

constexpr int most_steps = 100, most_newton_steps = 60;
constexpr int first_steps = 8;             // of Gauss and Newton, before what they gain is asked
constexpr double contraction = 0.8;        // of their steps, that tells that they converge
constexpr double energy_rounding = 1e-12;  // an energy that rises by no more than this share has not risen
constexpr double step_rounding = 1e-12;    // [rad]; shorter steps are made whatever they do to the energy
constexpr double step_floor = 1e-14;       // [rad]; a next step as short, at the present pace, is left out
constexpr double first_damping = 1e-3, least_damping = 1e-6, most_damping = 1e8;

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

template <LeastOf F>
LeastOutcome minimised(LeastProblem& problem) {
  LeastOutcome outcome{.converged = false, .last_step = std::numeric_limits<double>::infinity(), .widest = 0};
  double now = energy<F>(problem), damping = 0.0;
  bool newton = false;
  int newton_steps = 0;
  for (int i = 0; i < most_steps && std::isfinite(now) && damping < most_damping; ++i) {
    if (newton && ++newton_steps > most_newton_steps) break;
    const std::optional<LeastStep> step =
        newton ? newton_step<F>(problem, damping) : gauss_newton_step<F>(problem, damping);
    newton = newton || (i >= first_steps && !(step->size < least_tolerance) &&
                        (damping > 0.0 || !(step->size < contraction * outcome.last_step)));
    std::vector<LeastNode> before = problem.nodes;
    if (step) move(problem, *step);
    const double there = energy<F>(problem);
    const bool falls = there <= now * (1.0 + energy_rounding);
    if (!step || !(falls || step->size < step_rounding)) {
      problem.nodes = std::move(before);
      damping = std::max(4.0 * damping, first_damping);
      continue;
    }
    const bool settled = damping == 0.0 && step->size < least_tolerance;
    if (settled && outcome.converged && !(step->size < outcome.last_step)) {  // rounding
      problem.nodes = std::move(before);
      break;
    }
    const bool exact = settled && step->size * step->size < step_floor * outcome.last_step;
    now = there;
    outcome = {.converged = settled, .last_step = step->size, .widest = step->widest};
    if (exact) break;
    damping = damping > least_damping ? 0.1 * damping : 0.0;
  }
  return outcome;
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

}  // namespace orispline::inline ORISPLINE_ABI::families
