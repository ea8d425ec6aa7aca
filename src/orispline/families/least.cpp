// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/torque.hpp>
#include <orispline/families/auto.hpp>
#include <orispline/families/global_c2.hpp>
#include <orispline/families/least_minimisation.hpp>
#include <orispline/families/rotation_spline.hpp>

namespace orispline::inline ORISPLINE_ABI::families {
namespace {

constexpr std::size_t omega = 3, alpha = 6;  // first of their three unknowns at a node

Expected<Eigen::Matrix3d> inertia_of(const FamilySettings& settings) {
  const std::vector<double> j = settings.per_key("inertia").values();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity() * j[0];
  if (j.size() > 1) inertia.diagonal() << j[0], j[1], j[2];
  if (j.size() > 3) {
    inertia(0, 1) = inertia(1, 0) = j[3];
    inertia(0, 2) = inertia(2, 0) = j[4];
    inertia(1, 2) = inertia(2, 1) = j[5];
  }
  return checked_inertia(inertia);
}

LeastOf energy_of(const FamilySettings& settings) {
  const auto word = std::ranges::find(Least::energies, settings.choice("energy"));
  return static_cast<LeastOf>(word - Least::energies.begin());
}

/// A curve that is near: the first that there is of `global-c2`, `rotation-spline` and `auto`.
Expected<AnyCurve> start_curve(const Keyframes& keys, const FamilySettings& settings) {
  FamilySettings with = settings;
  with.parameters.emplace("nu", PerKey({0.0}));
  with.parameters.emplace("hold", PerKey({0.0}));
  if (auto curve = GlobalC2::curve(keys, with)) return AnyCurve(std::move(*curve));
  if (auto curve = RotationSpline::curve(keys, with)) return AnyCurve(std::move(*curve));
  return Auto::curve(keys, with).map([](auto curve) { return AnyCurve(std::move(curve)); });
}

void fix(LeastProblem& problem, std::size_t node, std::size_t first, const Eigen::Vector3d& rate) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = rate[static_cast<Eigen::Index>(axis)];
    if (std::isnan(value)) continue;
    problem.fixed[node].set(first + axis);
    problem.nodes[node].rates[static_cast<Eigen::Index>(first + axis) - 3] = value;
  }
}

void fix_end(LeastProblem& problem, std::size_t node, const End& end) {
  if (end.rule == EndRule::clamped) fix(problem, node, omega, end.angular_velocity);
  if (end.rule == EndRule::rest) fix(problem, node, omega, Eigen::Vector3d::Zero());
  if (end.rule == EndRule::natural && problem.of == LeastOf::acceleration && !problem.fixed[node].test(alpha))
    fix(problem, node, alpha, Eigen::Vector3d::Zero());
}

LeastNode node_of(const Eigen::Quaterniond& orientation, const Motion& m) {
  ChartEnd<3> rates;
  rates << m.angular_velocity, m.angular_acceleration;
  return {orientation, rates};
}

/// Every interval in `steps` equal pieces.
LeastProblem stated(const Keyframes& keys, const FamilySettings& settings, const Knots& knots, const AnyCurve& start,
                    std::size_t steps) {
  LeastProblem problem{.of = energy_of(settings)};
  for (std::size_t i = 0; i < knots.segments(); ++i)
    for (std::size_t k = 0; k < steps; ++k) {
      const KnotSpan span = knots.span(i);
      const double share = static_cast<double>(k) / static_cast<double>(steps);
      const Motion m = start.motion_on(i, span.start() + share * span.step());
      problem.nodes.push_back(node_of(k == 0 ? keys.orientations()[i] : m.orientation, m));
      problem.durations.push_back(span.step() / static_cast<double>(steps));
    }
  problem.nodes.push_back(
      node_of(keys.orientations().back(), start.motion_on(knots.segments() - 1, knots.back())));
  problem.fixed.resize(problem.nodes.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t k = 0; k < omega; ++k) problem.fixed[i * steps].set(k);
    if (!keys.angular_velocities().empty()) fix(problem, i * steps, omega, keys.angular_velocities()[i]);
    if (!keys.angular_accelerations().empty()) fix(problem, i * steps, alpha, keys.angular_accelerations()[i]);
  }
  fix_end(problem, 0, settings.start);
  fix_end(problem, problem.nodes.size() - 1, settings.end);
  return problem;
}

RefinedPiece<5> piece_of(const LeastProblem& problem, std::size_t i, std::size_t steps) {
  const LeastNode &from = problem.nodes[i], &to = problem.nodes[i + 1];
  const Eigen::Vector3d half = 0.5 * increment<double>(from.orientation, to.orientation);
  const auto rates = [](const LeastNode& node) {
    return std::array<Eigen::Vector3d, 3>{node.rates.head<3>(), node.rates.tail<3>(), Eigen::Vector3d::Zero()};
  };
  const double count = static_cast<double>(steps);
  return {static_cast<double>(i % steps) / count, static_cast<double>(i % steps + 1) / count,
          hermite_piece<2>(from.orientation * exp<double>(half), -half, half, rates(from), rates(to),
                           problem.durations[i])};
}

Error not_converged(const LeastOutcome& outcome, std::size_t steps) {
  return {ErrorCode::not_converged,
          formatted("{} does not converge for these keys: the residual stays at {:.3g}, wanted {:g}; put keys in "
                    "between, or take a local method such as timed-c2",
                    Least::info.name, outcome.last_step, least_tolerance),
          {.key = outcome.widest / steps}};
}

}  // namespace

Expected<RefinedChartCurve<5>> Least::curve(const Keyframes& keys, const FamilySettings& settings) {
  const auto steps = settings.whole("nodes");
  if (!steps) return tl::unexpected(steps.error());
  auto inertia = inertia_of(settings);
  if (!inertia) return tl::unexpected(std::move(inertia.error()));
  auto start = start_curve(keys, settings);
  if (!start) return tl::unexpected(std::move(start.error()));
  Knots knots = key_knots(keys);
  const auto count = static_cast<std::size_t>(*steps);
  LeastProblem problem = stated(keys, settings, knots, *start, count);
  problem.inertia = *inertia;
  const LeastOutcome outcome = minimise(problem);
  if (!outcome.converged) return tl::unexpected(not_converged(outcome, count));
  std::vector<RefinedPiece<5>> pieces;
  pieces.reserve(problem.durations.size());
  for (std::size_t i = 0; i < problem.durations.size(); ++i) pieces.push_back(piece_of(problem, i, count));
  return RefinedChartCurve<5>(std::move(knots), std::move(pieces));
}

}  // namespace orispline::inline ORISPLINE_ABI::families
