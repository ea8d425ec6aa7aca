// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/torque.hpp>
#include <orispline/families/auto.hpp>
#include <orispline/families/global_c2.hpp>
#include <orispline/families/least_minimisation.hpp>
#include <orispline/families/least_refinement.hpp>
#include <orispline/families/rotation_spline.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr std::size_t omega = 3, alpha = 6;  // first of their three unknowns at a node

Eigen::Matrix3d inertia_of(const FamilySettings& settings) {
  const std::vector<double> j = settings.per_key("inertia").values();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity() * j[0];
  if (j.size() > 1) inertia.diagonal() << j[0], j[1], j[2];
  if (j.size() > 3) {
    inertia(0, 1) = inertia(1, 0) = j[3];
    inertia(0, 2) = inertia(2, 0) = j[4];
    inertia(1, 2) = inertia(2, 1) = j[5];
  }
  return inertia;
}

LeastOf energy_of(const FamilySettings& settings) {
  const auto word = std::ranges::find(Least::energies, settings.choice("energy"));
  return static_cast<LeastOf>(word - Least::energies.begin());
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

/// How many pieces each interval has, all as long.
using Counts = std::vector<std::size_t>;

LeastProblem stated(const Keyframes& keys, const FamilySettings& settings, const Knots& knots, const AnyCurve& start,
                    const Counts& counts) {
  LeastProblem problem{.of = energy_of(settings), .inertia = inertia_of(settings)};
  std::vector<std::size_t> at_keys;
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const KnotSpan span = knots.span(i);
    const auto count = static_cast<double>(counts[i]);
    at_keys.push_back(problem.nodes.size());
    for (std::size_t k = 0; k < counts[i]; ++k) {
      const Motion m = start.motion_on(i, span.start() + static_cast<double>(k) / count * span.step());
      problem.nodes.push_back(node_of(k == 0 ? keys.orientations()[i] : m.orientation, m));
      problem.durations.push_back(span.step() / count);
    }
  }
  at_keys.push_back(problem.nodes.size());
  problem.nodes.push_back(node_of(keys.orientations().back(), start.motion_on(knots.segments() - 1, knots.back())));
  problem.fixed.resize(problem.nodes.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t k = 0; k < omega; ++k) problem.fixed[at_keys[i]].set(k);
    if (!keys.angular_velocities().empty()) fix(problem, at_keys[i], omega, keys.angular_velocities()[i]);
    if (!keys.angular_accelerations().empty()) fix(problem, at_keys[i], alpha, keys.angular_accelerations()[i]);
  }
  fix_end(problem, 0, settings.start);
  fix_end(problem, problem.nodes.size() - 1, settings.end);
  return problem;
}

ChartPiece<5> piece_after(const LeastProblem& problem, std::size_t node) {
  const LeastNode &from = problem.nodes[node], &to = problem.nodes[node + 1];
  const Eigen::Vector3d half = 0.5 * problem.increment_after(node);
  const auto rates = [](const LeastNode& n) {
    return std::array<Eigen::Vector3d, 3>{n.rates.head<3>(), n.rates.tail<3>(), Eigen::Vector3d::Zero()};
  };
  return hermite_piece<2>(from.orientation * exp<double>(half), -half, half, rates(from), rates(to),
                          problem.durations[node]);
}

/// The curve through the nodes, and the excess of each interval.
struct Found {
  std::vector<RefinedPiece<5>> pieces{};
  std::vector<double> excesses{};
};

Found found(const LeastProblem& problem, const Counts& counts) {
  Found found;
  for (std::size_t i = 0, node = 0; i < counts.size(); ++i) {
    const auto count = static_cast<double>(counts[i]);
    found.excesses.push_back(0.0);
    for (std::size_t k = 0; k < counts[i]; ++k, ++node) {
      const auto from = static_cast<double>(k);
      found.pieces.push_back({from / count, (from + 1.0) / count, piece_after(problem, node)});
      found.excesses.back() +=
          excess_of(problem.of, problem.inertia, found.pieces.back().chart, problem.durations[node]);
    }
  }
  return found;
}

/// Minima that the iteration comes to, the best of them.
class Descents {
 public:
  Descents(const Keyframes& keys, const FamilySettings& settings, const Knots& knots, const Counts& counts)
      : keys_(keys), settings_(settings), knots_(knots), counts_(counts) {}

  /// Begins on that curve.
  void from(const AnyCurve& start) {
    LeastProblem problem = stated(keys_, settings_, knots_, start, counts_);
    const LeastOutcome outcome = minimise(problem);
    if (!first_) first_ = outcome;
    if (!outcome.converged) return;
    const double energy = energy_of(problem);
    if (best_ && !(energy < energy_)) return;
    best_ = std::move(problem);
    energy_ = energy;
  }

  /// Whether the first one was found without Newton's method: such keys have one minimum.
  [[nodiscard]] bool easy() const { return first_ && first_->easy && first_->converged; }
  [[nodiscard]] const LeastOutcome& first() const { return *first_; }
  [[nodiscard]] std::optional<LeastProblem>& best() { return best_; }

 private:
  const Keyframes& keys_;
  const FamilySettings& settings_;
  const Knots& knots_;
  const Counts& counts_;
  std::optional<LeastOutcome> first_;
  std::optional<LeastProblem> best_;
  double energy_ = 0.0;
};

/// The descents from `global-c2` and `rotation-spline`, first from that which has less of the energy, and from `auto`:
/// after the first one only where keys are hard.
Expected<Descents> descents(const Keyframes& keys, const FamilySettings& settings, const Knots& knots,
                            const Counts& counts) {
  FamilySettings with = settings;
  with.parameters.emplace("nu", PerKey({0.0}));
  with.parameters.emplace("hold", PerKey({0.0}));
  std::vector<std::pair<double, AnyCurve>> starts;
  const auto take = [&](auto curve) {
    if (!curve) return;
    AnyCurve start(std::move(*curve));
    const double energy = energy_of(stated(keys, settings, knots, start, counts));
    starts.emplace_back(energy, std::move(start));
  };
  take(GlobalC2::curve(keys, with));
  take(RotationSpline::curve(keys, with));
  if (starts.size() == 2 && starts[1].first < starts[0].first) std::swap(starts[0], starts[1]);
  Descents all(keys, settings, knots, counts);
  for (const auto& [energy, start] : starts) {
    all.from(start);
    if (all.easy()) return all;
  }
  auto local = Auto::curve(keys, with);
  if (!local && starts.empty()) return tl::unexpected(std::move(local.error()));
  if (local) all.from(AnyCurve(std::move(*local)));
  return all;
}

/// The key at a node, or before it.
std::size_t key_before(std::size_t node, const Counts& counts) {
  std::size_t key = 0;
  for (std::size_t first = 0; key < counts.size() && first + counts[key] <= node; ++key) first += counts[key];
  return key;
}

Error not_converged(const LeastOutcome& outcome, const Counts& counts) {
  return {ErrorCode::not_converged,
          formatted("{} does not converge for these keys: the residual stays at {:.3g}, wanted {:g}; put keys in "
                    "between, or take a local method such as timed-c2",
                    Least::info.name, outcome.last_step, least_tolerance),
          {.key = key_before(outcome.widest, counts)}};
}

constexpr int most_refinements = 5;

}  // namespace

Expected<RefinedChartCurve<5>> Least::curve(const Keyframes& keys, const FamilySettings& settings) {
  const auto nodes = settings.whole("nodes");
  if (!nodes) return tl::unexpected(nodes.error());
  if (auto inertia = checked_inertia(inertia_of(settings)); !inertia) return tl::unexpected(std::move(inertia.error()));
  const Knots knots = key_knots(keys);
  Counts counts(knots.segments(), static_cast<std::size_t>(*nodes));
  auto all = descents(keys, settings, knots, counts);
  if (!all) return tl::unexpected(std::move(all.error()));
  if (!all->best()) return tl::unexpected(not_converged(all->first(), counts));
  LeastProblem problem = std::move(*all->best());
  for (int round = 0;; ++round) {
    Found least = found(problem, counts);
    const Counts more = refined(counts, least.excesses, energy_of(problem));
    RefinedChartCurve<5> curve(knots, std::move(least.pieces));
    if (more.empty() || round == most_refinements) return curve;
    counts = more;
    problem = stated(keys, settings, knots, AnyCurve(std::move(curve)), counts);
    if (const LeastOutcome outcome = minimise(problem); !outcome.converged)
      return tl::unexpected(not_converged(outcome, counts));
  }
}

}}}  // namespace orispline::families
