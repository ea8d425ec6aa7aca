// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <orispline/base/expect.hpp>
#include <orispline/math/chain_elimination.hpp>
#include <orispline/math/number.hpp>
#include <orispline/smooth/bias_rows.hpp>
#include <orispline/smooth/node_variances.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_loss.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The recording itself, with the mean rates about each time; times without an orientation take the nearest earlier
/// one.
SmoothedNodes recorded_nodes(const SmoothingProblem& problem) {
  const auto first = std::ranges::find_if(problem.weights, [](double w) { return w > 0.0; });
  ORISPLINE_EXPECT(first != problem.weights.end());
  auto latest = static_cast<std::size_t>(first - problem.weights.begin());
  SmoothedNodes nodes;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (problem.weights[i] > 0.0) latest = i;
    nodes.orientations.push_back(problem.orientations[latest]);
  }
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, problem.size() - 1);
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    for (std::size_t k = before; k < after; ++k)
      way += shortest_increment(nodes.orientations[k], nodes.orientations[k + 1]);
    nodes.angular_velocities.emplace_back(way / (problem.times[after] - problem.times[before]));
  }
  nodes.angular_accelerations.assign(problem.size(), Eigen::Vector3d::Zero());
  return nodes;
}

constexpr double cost_rounding = 1e-12;    // a cost that rises by no more than this share has not risen
constexpr double contraction = 0.5;        // of steps, that tells that the iteration converges
constexpr int most_steps_across = 6;       // of a valley
constexpr double doubt = 3.0;              // of a step that is foreseen, at most so much longer
constexpr double farthest_foreseen = 0.1;  // [rad], beyond which a step tells nothing of the next
constexpr double farthest_alike = 10.0;    // a step this many times as long as one known is no guide to the next
constexpr double smallest_share = 1e-4;    // of the step that Gauss and Newton propose

/// Whether there is a gyro, what its bias is, and whether the noise of the orientations has a part that correlates.
enum class Unknowns { of_motion, motion_and_noise, shared_bias, drifting_bias, drifting_bias_and_noise };

/// The iteration for a penalty of order P, with or without a gyro.
template <int P, Unknowns Kind>
class Minimisation {
 public:
  Minimisation(const SmoothingProblem& problem, const SmoothingObjective& objective, const SmoothedNodes* start)
      : problem_(problem), objective_(objective), state_(taken_from(start ? *start : recorded_nodes(problem))) {}

  /// Of the majorising normal matrix.
  [[nodiscard]] double log_determinant() {
    [[maybe_unused]] const BiasRows bias_rows = eliminated_majorant();
    double sum = chain_.log_determinant();
    if constexpr (shares)
      if (objective_.bias == SmoothingObjective::Bias::constant) sum += bias_rows.log_determinant();
    return sum;
  }

  /// By the inverse of that matrix.
  [[nodiscard]] NodeSigmas sigmas() {
    [[maybe_unused]] const BiasRows bias_rows = eliminated_majorant();
    NodeVariances<P> variances(chain_, state_.orientations, state_.rates);
    if constexpr (shares)
      if (objective_.bias == SmoothingObjective::Bias::constant) variances.add_shared(chain_, bias_rows.inverse_root());
    return variances.roots([this](std::size_t i) {
      return WeighedStep{.length = duration(i), .lambda = objective_.lambda * problem_.relative_lambda(i)};
    });
  }

  [[nodiscard]] SmoothingFit run(const SmoothingIteration& iteration) {
    Evaluation now = evaluated(state_);
    SmoothingFit fit;
    fit.steps = iteration.steps;
    double turn_before = std::numeric_limits<double>::infinity();
    for (fit.iterations = 1;; ++fit.iterations) {
      const Step step = proposed(now);
      if (objective_.stopped()) break;
      fit.last_step = step.largest_turn;
      if (fit.iterations > 1) fit.steps = {.ratio = step.largest_turn / turn_before, .of = turn_before};
      if (!std::isfinite(step.size)) break;
      const double cost_before = now.cost;
      const double length = advance(now, step);
      if (objective_.work) objective_.work->add(static_cast<double>(problem_.size()));
      const bool stays =
          std::abs(now.cost - cost_before) <= cost_rounding * cost_before;  // a step that grows is rounding
      if (step.largest_turn < iteration.tolerance && length == 1.0) break;
      if (stays && step.largest_turn >= turn_before) break;
      const bool known = step.largest_turn <= std::min(farthest_foreseen, farthest_alike * fit.steps.of);
      const double next = doubt * fit.steps.next(step.largest_turn);
      if (iteration.foresees && length == 1.0 && known && next < iteration.tolerance) {
        fit.last_step = next;
        break;
      }
      if (fit.iterations >= iteration.most || objective_.stopped()) break;
      turn_before = step.largest_turn;
    }
    if (lowest_ && !(now.cost <= lowest_cost_)) {
      state_ = std::move(*lowest_);
      now = evaluated(state_);
    }
    return completed(std::move(fit), std::move(now));
  }

 private:
  using Element = SmoothingElement<P>;
  using Rates = typename Element::Rates;
  static constexpr bool shares = Kind == Unknowns::shared_bias,
                        drifts = Kind == Unknowns::drifting_bias || Kind == Unknowns::drifting_bias_and_noise,
                        correlates = Kind == Unknowns::motion_and_noise || Kind == Unknowns::drifting_bias_and_noise,
                        has_gyro = shares || drifts;
  static constexpr int of_element = Element::unknowns, of_motion = of_element + (drifts ? 3 : 0);
  static constexpr int unknowns = of_motion + (correlates ? 3 : 0),
                       data_rows = 3 + (has_gyro ? 3 : 0) + (correlates ? 3 : 0), sides = shares ? 4 : 1;
  using Chain = ChainElimination<unknowns, data_rows, sides>;
  using Low = typename Chain::Low;
  using BiasRows = orispline::BiasRows<Chain::Remainder::RowsAtCompileTime, sides>;

  struct Step {
    std::vector<Eigen::Matrix<double, unknowns, 1>> nodes;
    Eigen::Vector3d bias = Eigen::Vector3d::Zero();
    double largest_turn = 0.0;  // of a node [rad]
    double size = 0.0;          // largest change of a node, its rates times powers of the mean interval [rad]
  };

  struct State {
    std::vector<Eigen::Quaterniond> orientations;
    std::vector<Rates> rates;
    Eigen::Vector3d bias = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> biases{};  // of the nodes, where it drifts
    std::vector<Eigen::Vector3d> noises{};  // that keep [rad]

    [[nodiscard]] State after(const Step& step, double length) const {
      State moved{orientations, rates, bias + length * step.bias, biases, noises};
      for (std::size_t i = 0; i < rates.size(); ++i) {
        const Eigen::Vector3d turn = length * step.nodes[i].template head<3>();
        moved.orientations[i] = (orientations[i] * exp<double>(turn)).normalized();
        moved.rates[i] += length * step.nodes[i].template segment<of_element - 3>(3);
        if constexpr (drifts) moved.biases[i] += length * step.nodes[i].template segment<3>(of_element);
        if constexpr (correlates) moved.noises[i] += length * step.nodes[i].template tail<3>();
      }
      return moved;
    }
  };

  struct Evaluation {
    std::vector<Eigen::Vector3d> residuals, steps;
    std::vector<double> loss_weights, curvatures, interval_penalties;
    double data = 0.0, penalty = 0.0, gyro = 0.0, cost = 0.0;
  };

  [[nodiscard]] double duration(std::size_t i) const { return problem_.times[i + 1] - problem_.times[i]; }

  [[nodiscard]] Eigen::Vector3d gyro_residual(const State& state, std::size_t i) const {
    const Eigen::Vector3d off = state.rates[i].template head<3>() - problem_.gyro[i];
    return live_axes_.cwiseProduct(off) - (drifts ? state.biases[i] : state.bias);
  }

  /// What is left of a residual without the noise that correlates.
  [[nodiscard]] Eigen::Vector3d white_part(const State& state, std::size_t i, const Eigen::Vector3d& residual) const {
    if constexpr (correlates) return residual - state.noises[i];
    return residual;
  }

  /// The change of a bias that drifts, in its σ.
  [[nodiscard]] Eigen::Vector3d walk_residual(const State& state, std::size_t i) const {
    return (state.biases[i + 1] - state.biases[i]) / walk_sigma(i);
  }
  [[nodiscard]] double walk_sigma(std::size_t i) const { return objective_.drift * std::sqrt(duration(i)); }

  /// Of the noise that correlates, how much of it does until the next node, and the change in its σ.
  [[nodiscard]] double correlation(std::size_t i) const {
    return elementary::exponential(-duration(i) / objective_.correlation_time);
  }
  [[nodiscard]] double fresh_sigma(std::size_t i) const {
    const double share = correlation(i);
    return objective_.correlated_noise * std::sqrt(1.0 - share * share);
  }
  [[nodiscard]] Eigen::Vector3d fresh_residual(const State& state, std::size_t i) const {
    return (state.noises[i + 1] - correlation(i) * state.noises[i]) / fresh_sigma(i);
  }

  [[nodiscard]] static State taken_from(const SmoothedNodes& nodes) {
    State state{nodes.orientations, {}, nodes.gyro_correction, nodes.gyro_corrections, nodes.correlated_noises};
    if (correlates && state.noises.empty()) state.noises.assign(nodes.orientations.size(), Eigen::Vector3d::Zero());
    if (drifts && state.biases.empty()) state.biases.assign(nodes.orientations.size(), nodes.gyro_correction);
    for (std::size_t i = 0; i < nodes.orientations.size(); ++i) {
      Rates& rates = state.rates.emplace_back();
      rates.template head<3>() = nodes.angular_velocities[i];
      if constexpr (P == 3) rates.template tail<3>() = nodes.angular_accelerations[i];
    }
    return state;
  }

  [[nodiscard]] Evaluation evaluated(const State& state) const {
    Evaluation e;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const double w = problem_.weights[i];
      const Eigen::Vector3d r = w > 0.0 ? shortest_increment(state.orientations[i], problem_.orientations[i])
                                        : Eigen::Vector3d(Eigen::Vector3d::Zero());
      const LossValue loss = loss_at(objective_.loss, w * white_part(state, i, r).squaredNorm(), objective_.threshold);
      e.residuals.push_back(r);
      e.loss_weights.push_back(loss.weight);
      e.curvatures.push_back(loss.curvature);
      e.data += loss.value;
      if constexpr (has_gyro) e.gyro += problem_.gyro_weights[i] * gyro_residual(state, i).squaredNorm();
      if constexpr (correlates)
        if (i == 0) e.gyro += (state.noises[0] / objective_.correlated_noise).squaredNorm();
      if (i + 1 == problem_.size()) break;
      if constexpr (correlates) e.gyro += fresh_residual(state, i).squaredNorm();
      if constexpr (drifts) e.gyro += walk_residual(state, i).squaredNorm();
      e.steps.push_back(shortest_increment(state.orientations[i], state.orientations[i + 1]));
      e.interval_penalties.push_back(
          Element::residual(e.steps[i], state.rates[i], state.rates[i + 1], duration(i)).squaredNorm());
      e.penalty += problem_.relative_lambda(i) * e.interval_penalties[i];
    }
    e.cost = e.data + objective_.lambda * e.penalty + e.gyro;
    return e;
  }

  /// The rows of node i about itself and of its link to the next one.
  [[nodiscard]] Low rows_of(const Evaluation& now, std::size_t i) const {
    Low low = Low::Zero();
    constexpr int side = 2 * unknowns;
    const double root = std::sqrt(problem_.weights[i] * now.loss_weights[i]);
    const Eigen::Vector3d residual = white_part(state_, i, now.residuals[i]);
    low.template topLeftCorner<3, 3>().diagonal().setConstant(root);
    low.template block<3, 1>(0, side) = root * residual;
    if (now.curvatures[i] < 1.0) {  // along the residual by its root, which the right-hand side makes up for
      const double share = std::sqrt(now.curvatures[i]);
      low.template topLeftCorner<3, 3>() +=
          root * (share - 1.0) / residual.squaredNorm() * residual * residual.transpose();
      low.template block<3, 1>(0, side) /= share;
    }
    if constexpr (correlates) {
      low.template block<3, 3>(0, of_motion) = low.template topLeftCorner<3, 3>();
      if (i == 0) {
        low.template block<3, 3>(data_rows - 3, of_motion).diagonal().setConstant(1.0 / objective_.correlated_noise);
        low.template block<3, 1>(data_rows - 3, side) = -state_.noises[0] / objective_.correlated_noise;
      }
    }
    if constexpr (has_gyro) {
      const double gyro_root = std::sqrt(problem_.gyro_weights[i]);
      low.template block<3, 3>(3, 3).diagonal() = gyro_root * live_axes_;
      low.template block<3, 1>(3, side) = -gyro_root * gyro_residual(state_, i);
      if constexpr (drifts) low.template block<3, 3>(3, of_element).diagonal().setConstant(-gyro_root);
      else if (objective_.bias == SmoothingObjective::Bias::constant)
        low.template block<3, 3>(3, side + 1).diagonal().setConstant(gyro_root);
    }
    if (i + 1 < problem_.size()) {
      const auto e = Element::linearised(now.steps[i], state_.rates[i], state_.rates[i + 1], duration(i));
      const double penalty_root = std::sqrt(objective_.lambda * problem_.relative_lambda(i));
      low.template block<of_element, of_element>(data_rows, 0) =
          penalty_root * e.jacobian.template leftCols<of_element>();
      low.template block<of_element, of_element>(data_rows, unknowns) =
          penalty_root * e.jacobian.template rightCols<of_element>();
      low.template block<of_element, 1>(data_rows, side) = -penalty_root * e.residual;
      if constexpr (drifts) add_walk(low, i);
      if constexpr (correlates) add_correlated_noise(low, i);
    }
    return low;
  }

  /// The rows of a bias that drifts, from node i to the next one.
  void add_walk(Low& low, std::size_t i) const {
    constexpr int row = data_rows + of_element;
    const double root = 1.0 / walk_sigma(i);
    low.template block<3, 3>(row, of_element).diagonal().setConstant(-root);
    low.template block<3, 3>(row, unknowns + of_element).diagonal().setConstant(root);
    low.template block<3, 1>(row, 2 * unknowns) = -walk_residual(state_, i);
  }

  void add_correlated_noise(Low& low, std::size_t i) const {
    constexpr int row = data_rows + of_motion;
    const double root = 1.0 / fresh_sigma(i);
    low.template block<3, 3>(row, of_motion).diagonal().setConstant(-root * correlation(i));
    low.template block<3, 3>(row, unknowns + of_motion).diagonal().setConstant(root);
    low.template block<3, 1>(row, 2 * unknowns) = -fresh_residual(state_, i);
  }

  /// Moves by the step, or by a part of it, which is returned.
  ///
  /// The whole step is taken where the cost falls, and also where steps that shrink (Deuflhard's natural test) soon
  /// take the cost below what it was: strong penalties have bent valleys, across which good steps first raise the cost.
  double advance(Evaluation& now, const Step& step) {
    State from = std::move(state_);
    for (double length = 1.0;; length *= 0.5) {
      state_ = from.after(step, length);
      Evaluation there = evaluated(state_);
      // The shortest step is made even uphill: it may cross where the shorter way between two nodes changes sides, and
      // the cost goes down again beyond.
      const bool rises = !(there.cost <= now.cost * (1.0 + cost_rounding));
      if (!rises || length < smallest_share) {
        if (rises && now.cost < lowest_cost_) {
          lowest_ = std::move(from);
          lowest_cost_ = now.cost;
        }
        now = std::move(there);
        return length;
      }
      if (length == 1.0 && std::isfinite(there.cost) && passes_watchdog(now, step, std::move(there))) return length;
      if (objective_.stopped()) return length;
    }
  }

  /// Whether the steps that follow pay for the first; then they are taken too.
  bool passes_watchdog(Evaluation& now, const Step& first, Evaluation there) {
    double size = first.size;
    for (int k = 0; k < most_steps_across; ++k) {
      const Step next = proposed(there);
      if (objective_.stopped()) return false;
      if (!(next.size <= contraction * size)) return false;
      state_ = state_.after(next, 1.0);
      there = evaluated(state_);
      size = next.size;
      if (there.cost > now.cost * (1.0 + cost_rounding)) continue;
      now = std::move(there);
      return true;
    }
    return false;
  }

  BiasRows eliminated_majorant() {
    Evaluation now = evaluated(state_);
    std::ranges::fill(now.curvatures, 1.0);
    return eliminated(now);
  }

  /// Leaves the factor in the chain, of a part of it where the work is stopped.
  BiasRows eliminated(const Evaluation& now) {
    chain_.start(problem_.size());
    BiasRows bias_rows;
    for (std::size_t i = 0; i < problem_.size() && !objective_.stopped(); ++i) {
      const auto remainder = chain_.add(rows_of(now, i));
      if constexpr (shares) bias_rows.add(remainder);
    }
    return bias_rows;
  }

  /// The Gauss–Newton step from the present state; not to be made where the work is stopped.
  [[nodiscard]] Step proposed(const Evaluation& now) {
    [[maybe_unused]] const BiasRows bias_rows = eliminated(now);
    Step step;
    Eigen::Matrix<double, sides, 1> combination = Eigen::Matrix<double, sides, 1>::Zero();
    combination[0] = 1.0;
    if constexpr (shares)
      if (objective_.bias == SmoothingObjective::Bias::constant) {
        step.bias = bias_rows.solved();
        combination.template tail<3>() = step.bias;
      }
    step.nodes.resize(problem_.size());
    const double mean_interval =
        (problem_.times.back() - problem_.times.front()) / static_cast<double>(problem_.size() - 1);
    chain_.solve(combination, [&](std::size_t i, const auto& x) {
      step.nodes[i] = x;
      const double turn = x.template head<3>().norm();
      step.largest_turn = std::max(step.largest_turn, turn);
      double size = turn, unit = mean_interval;
      for (int k = 3; k < of_element; k += 3, unit *= mean_interval) size += unit * x.template segment<3>(k).norm();
      step.size = std::isfinite(size) ? std::max(step.size, size) : size;
    });
    return step;
  }

  [[nodiscard]] SmoothingFit completed(SmoothingFit fit, Evaluation now) {
    for (const Rates& rates : state_.rates) {
      fit.nodes.angular_velocities.push_back(rates.template head<3>());
      if constexpr (P == 3) fit.nodes.angular_accelerations.push_back(rates.template tail<3>());
    }
    if constexpr (P == 2)
      fit.nodes.angular_accelerations = mean_accelerations(problem_.times, now.steps, fit.nodes.angular_velocities);
    fit.nodes.orientations = std::move(state_.orientations);
    fit.nodes.gyro_correction = state_.bias;
    if constexpr (drifts) {
      fit.nodes.gyro_correction.setZero();
      for (const Eigen::Vector3d& bias : state_.biases)
        fit.nodes.gyro_correction += bias / static_cast<double>(state_.biases.size());
      fit.nodes.gyro_corrections = std::move(state_.biases);
    }
    fit.nodes.correlated_noises = std::move(state_.noises);
    fit.residuals = std::move(now.residuals);
    fit.loss_weights = std::move(now.loss_weights);
    fit.interval_penalties = std::move(now.interval_penalties);
    fit.data = now.data;
    fit.penalty = now.penalty;
    fit.gyro = now.gyro;
    fit.cost = now.cost;
    return fit;
  }

  const SmoothingProblem& problem_;
  const SmoothingObjective& objective_;
  const Eigen::Vector3d live_axes_{problem_.dead_gyro_axes[0] ? 0.0 : 1.0, problem_.dead_gyro_axes[1] ? 0.0 : 1.0,
                                   problem_.dead_gyro_axes[2] ? 0.0 : 1.0};  // 1, or 0 where the gyro is dead
  State state_;
  Chain chain_;                  // kept for its memory
  std::optional<State> lowest_;  // that was left uphill
  double lowest_cost_ = std::numeric_limits<double>::infinity();
};

/// Calls `use` with the iteration for the problem.
template <class Use>
auto with_minimisation(const SmoothingProblem& problem, const SmoothingObjective& objective, const SmoothedNodes* start,
                       Use use) {
  const auto of_order = [&]<int P>(std::integral_constant<int, P>) {
    if (problem.gyro.empty() && objective.correlated_noise > 0.0)
      return use(Minimisation<P, Unknowns::motion_and_noise>(problem, objective, start));
    if (problem.gyro.empty()) return use(Minimisation<P, Unknowns::of_motion>(problem, objective, start));
    if (objective.correlated_noise > 0.0)
      return use(Minimisation<P, Unknowns::drifting_bias_and_noise>(problem, objective, start));
    if (objective.bias == SmoothingObjective::Bias::drifting)
      return use(Minimisation<P, Unknowns::drifting_bias>(problem, objective, start));
    return use(Minimisation<P, Unknowns::shared_bias>(problem, objective, start));
  };
  return objective.penalty == Penalty::jerk ? of_order(std::integral_constant<int, 3>())
                                            : of_order(std::integral_constant<int, 2>());
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
