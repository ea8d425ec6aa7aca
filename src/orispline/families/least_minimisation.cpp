// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least_minimisation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr int first_steps = 4, most_first_steps = 60;  // of Gauss and Newton, before and after what they gain is asked
constexpr double contraction = 0.3;                    // of their steps, that tells that they converge soon
constexpr int most_newton_steps = 150, most_trials = 400;
constexpr double energy_rounding = 1e-12;  // an energy that rises by no more than this share has not risen
constexpr double step_rounding = 1e-12;    // [rad]; shorter steps are made whatever they do to the energy
constexpr double step_floor = 1e-14;       // [rad]; a next step as short, at the present pace, is left out
constexpr double first_damping = 1e-4, least_damping = 1e-7, most_damping = 1e10;
constexpr double longest_step = 4.0;        // [rad]
constexpr double longest_flat_step = 1e-3;  // [rad]; such a step that gains no more than rounding is the last one
constexpr double flat_gain = 1e-9;  // of the energy, whose rounding is as large where many turns take short times
constexpr double poor_gain = 0.25, good_gain = 0.75;  // of what a step should gain: more or less damping

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
  int trials = 0;
  for (int i = 0; i < most_newton_steps && std::isfinite(now); ++i) {
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
