// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least_minimisation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <orispline/math/chain_elimination.hpp>

namespace orispline::inline ORISPLINE_ABI::families {
namespace {

constexpr int most_steps = 200;
constexpr double energy_rounding = 1e-12;  // an energy that rises by no more than this share has not risen
constexpr double step_rounding = 1e-12;    // [rad]; shorter steps are made whatever they do to the energy
constexpr double first_damping = 1e-3, least_damping = 1e-6, most_damping = 1e8;

template <LeastOf F>
class Minimisation {
 public:
  explicit Minimisation(LeastProblem& problem) : problem_(problem) {}

  [[nodiscard]] LeastOutcome run() {
    LeastOutcome outcome{.converged = false, .last_step = std::numeric_limits<double>::infinity(), .widest = 0};
    double energy = energy_of(problem_.nodes), damping = 0.0;
    for (int i = 0; i < most_steps && std::isfinite(energy); ++i) {
      const Step step = damping > 0.0 ? proposed<9>(damping) : proposed<0>(0.0);
      std::vector<LeastNode> moved = after(step);
      const double there = energy_of(moved);
      if (!(there <= energy * (1.0 + energy_rounding)) && !(step.size < step_rounding)) {
        damping = std::max(4.0 * damping, first_damping);
        if (damping > most_damping) break;
        continue;
      }
      const bool settled = damping == 0.0 && step.size < least_tolerance;
      if (settled && !(step.size < outcome.last_step)) return outcome;  // rounding
      problem_.nodes = std::move(moved);
      energy = there;
      outcome = {.converged = settled, .last_step = step.size, .widest = step.widest};
      damping = damping > least_damping ? 0.1 * damping : 0.0;
    }
    return outcome;
  }

 private:
  using Element = LeastElement<F>;
  static constexpr int unknowns = Element::unknowns;

  struct Step {
    std::vector<Eigen::Matrix<double, unknowns, 1>> nodes;
    double size = 0.0;
    std::size_t widest = 0;
  };

  [[nodiscard]] Eigen::Vector3d increment_after(const std::vector<LeastNode>& nodes, std::size_t i) const {
    return increment<double>(nodes[i].orientation, nodes[i + 1].orientation);
  }

  [[nodiscard]] double energy_of(const std::vector<LeastNode>& nodes) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < problem_.durations.size(); ++i)
      sum += Element::residual(increment_after(nodes, i), nodes[i].rates, nodes[i + 1].rates, problem_.durations[i],
                               problem_.inertia)
                 .squaredNorm();
    return sum;
  }

  [[nodiscard]] std::vector<LeastNode> after(const Step& step) const {
    std::vector<LeastNode> moved = problem_.nodes;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (!problem_.fixed[i].test(0))
        moved[i].orientation = (moved[i].orientation * exp<double>(step.nodes[i].template head<3>())).normalized();
      moved[i].rates += step.nodes[i].template tail<6>();
    }
    return moved;
  }

  /// Sums of squares of the columns of turn, ω and α of a node: what damping is relative to, whatever the frame.
  using Weights = Eigen::Array3d;
  template <class Columns>
  static Weights weights_of(const Columns& columns) {
    return {columns.template middleCols<3>(0).squaredNorm(), columns.template middleCols<3>(3).squaredNorm(),
            columns.template middleCols<3>(6).squaredNorm()};
  }

  /// The step from the present nodes, by as many rows of damping for each.
  template <int Damping>
  [[nodiscard]] Step proposed(double damping) {
    using Chain = ChainElimination<unknowns, Damping, 1, Element::rows>;
    Chain chain;
    chain.start(problem_.nodes.size());
    Weights before = Weights::Zero();
    for (std::size_t i = 0; i < problem_.nodes.size(); ++i) {
      typename Chain::Low low = Chain::Low::Zero();
      auto link = low.template bottomRows<Element::rows>();
      if (i + 1 < problem_.nodes.size()) {
        const auto e = Element::linearised(increment_after(problem_.nodes, i), problem_.nodes[i].rates,
                                           problem_.nodes[i + 1].rates, problem_.durations[i], problem_.inertia);
        link.template leftCols<2 * unknowns>() = e.jacobian;
        link.template rightCols<1>() = -e.residual;
      }
      if constexpr (Damping > 0) {
        const Weights weights = before + weights_of(link);
        for (int k = 0; k < unknowns; ++k) low(k, k) = std::sqrt(damping * weights[k / 3]);
        before = weights_of(link.template middleCols<unknowns>(unknowns));
      }
      for (int k = 0; k < unknowns; ++k) {
        if (problem_.fixed[i].test(static_cast<std::size_t>(k))) {
          low.col(k).setZero();
          chain.fix(k);
        }
        if (i + 1 < problem_.nodes.size() && problem_.fixed[i + 1].test(static_cast<std::size_t>(k)))
          low.col(unknowns + k).setZero();
      }
      static_cast<void>(chain.add(low));
    }
    return solution(chain);
  }

  template <class Chain>
  [[nodiscard]] Step solution(const Chain& chain) const {
    Step step;
    step.nodes.resize(problem_.nodes.size());
    chain.solve(Eigen::Matrix<double, 1, 1>::Ones(), [&](std::size_t i, const auto& x) {
      step.nodes[i] = x;
      const double h = shorter_piece_beside(i);
      const double size = x.template head<3>().norm() + h * x.template segment<3>(3).norm() +
                          h * h * x.template tail<3>().norm();
      if (size <= step.size) return;  // not where it is NaN, which then stays
      step.size = size;
      step.widest = i;
    });
    return step;
  }

  [[nodiscard]] double shorter_piece_beside(std::size_t i) const {
    const auto& h = problem_.durations;
    return std::min(h[i > 0 ? i - 1 : 0], h[i < h.size() ? i : h.size() - 1]);
  }

  LeastProblem& problem_;
};

}  // namespace

LeastOutcome minimise(LeastProblem& problem) {
  switch (problem.of) {
    case LeastOf::torque:
      return Minimisation<LeastOf::torque>(problem).run();
    case LeastOf::jerk:
      return Minimisation<LeastOf::jerk>(problem).run();
    default:
      return Minimisation<LeastOf::acceleration>(problem).run();
  }
}

}  // namespace orispline::inline ORISPLINE_ABI::families
