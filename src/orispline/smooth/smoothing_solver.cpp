// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include <orispline/smooth/position_fit.hpp>
#include <orispline/smooth/smoothing_minimisation.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Calls `use` with the iteration for the problem.
template <class Use>
auto with_minimisation(const SmoothingProblem& problem, const SmoothingObjective& objective, const SmoothedNodes* start,
                       Use use) {
  const bool jerk = objective.penalty == Penalty::jerk;
  if (problem.gyro.empty())
    return jerk ? use(Minimisation<3, false>(problem, objective, start))
                : use(Minimisation<2, false>(problem, objective, start));
  return jerk ? use(Minimisation<3, true>(problem, objective, start))
              : use(Minimisation<2, true>(problem, objective, start));
}

/// The minima of weaker penalties that lead to a strong one of the jerk, the smoothing time doubled from each to the
/// next; nothing where it is not strong.
std::optional<SmoothedNodes> lead_to(const SmoothingProblem& problem, const SmoothingObjective& objective) {
  constexpr double far = 729e6;  // (τ over the interval)⁶ of 30, up to where the iteration finds its way alone
  const double interval =
      (problem.times.back() - problem.times.front()) / static_cast<double>(problem.times.size() - 1);
  const double weight = *std::ranges::max_element(problem.weights);  // of the orientations, 1/σ²
  double share = 1.0;
  while (objective.lambda * share > far * weight * interval * interval * interval * interval * interval &&
         share > 1e-60)
    share /= 64.0;
  const SmoothingIteration roughly{.tolerance = 0.01 / std::sqrt(weight)};
  std::optional<SmoothedNodes> nodes;
  for (; share < 1.0 && !objective.stopped(); share *= 64.0) {
    SmoothingObjective weaker = objective;
    weaker.lambda *= share;
    nodes = with_minimisation(problem, weaker, nodes ? &*nodes : nullptr,
                              [&](auto&& minimisation) { return minimisation.run(roughly).nodes; });
  }
  return nodes;
}

}  // namespace

SmoothingFit fit_smoothing(const SmoothingProblem& problem, const SmoothingObjective& objective,
                           const SmoothingIteration& iteration, const SmoothedNodes* start) {
  if (!problem.positions.empty()) return fit_positions(problem, objective, iteration, start);
  std::optional<SmoothedNodes> lead;
  if (!start && objective.penalty == Penalty::jerk) {
    lead = lead_to(problem, objective);
    if (lead) start = &*lead;
  }
  return with_minimisation(problem, objective, start, [&](auto&& minimisation) { return minimisation.run(iteration); });
}

NodeSigmas node_sigmas(const SmoothingProblem& problem, const SmoothingObjective& objective,
                       const SmoothedNodes& nodes) {
  return with_minimisation(problem, objective, &nodes, [](auto&& minimisation) { return minimisation.sigmas(); });
}

double log_determinant(const SmoothingProblem& problem, const SmoothingObjective& objective,
                       const SmoothedNodes& nodes) {
  return with_minimisation(problem, objective, &nodes,
                           [](auto&& minimisation) { return minimisation.log_determinant(); });
}

}}  // namespace orispline
