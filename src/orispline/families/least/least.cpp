// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/least/least.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/refined_chart_curve.hpp>
#include <orispline/families/auto.hpp>
#include <orispline/families/global_c2.hpp>
#include <orispline/families/least/element.hpp>
#include <orispline/families/least/minimisation.hpp>
#include <orispline/families/rotation_spline.hpp>
#include <orispline/math/chain_elimination.hpp>
#include <orispline/math/scalar_link.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr double excess_share = 2e-9;        // of the energy, that is let be
constexpr std::size_t most_pieces = 256;     // of an interval
constexpr double rounding_of_turns = 1e-11;  // [rad]; so little within a piece is no excess
/// Of the excess by the change of momentum, measured against twice as many pieces.
constexpr double scale_of_excess = 1e-4, scale_of_jerk_excess = 1e-5;

/// Half the momentum of the orientation in the body frame at u of a piece, and the turn from there to the world.
Eigen::Vector3d momentum(LeastOf of, const Eigen::Matrix3d& inertia, const ChartPiece<5>& piece, double h, double u) {
  const auto path = rotation_vector(piece, Jet<double, 5>::variable(u));
  const auto rate = chart_rate<double, 5>(path);
  double power = h;
  std::array<Eigen::Vector3d, 5> omega;  // ω and its derivatives
  for (std::size_t k = 0; k < omega.size(); ++k, power *= h)
    omega[k] = Eigen::Vector3d(rate.x().derivative(k), rate.y().derivative(k), rate.z().derivative(k)) / power;
  const Motion m{.orientation = piece.base * exp<double>({path.x().c[0], path.y().c[0], path.z().c[0]}),
                 .angular_velocity = omega[0],
                 .angular_acceleration = omega[1],
                 .angular_jerk = omega[2]};
  if (of == LeastOf::jerk) return m.orientation * omega[4];
  if (of == LeastOf::acceleration) return m.orientation * omega[2];
  const Eigen::Vector3d force = torque(m, inertia);
  const Eigen::Vector3d spun = (inertia * omega[0]).cross(force) + inertia * force.cross(omega[0]);
  return m.orientation * (inertia * torque_rate(m, inertia) - spun);
}

/// How much of a piece's energy is more than it need be, by its residual of the equations of Euler and Lagrange.
///
/// Between keys they say that the momentum P of the orientation is constant in the world frame: P = R ω″ for the
/// acceleration, whence ω‴ = ω″ × ω. What P changes by within a piece of h [s] tells how far it is from there.
double excess_of(LeastOf of, const Eigen::Matrix3d& inertia, const ChartPiece<5>& piece, double h) {
  const bool of_jerk = of == LeastOf::jerk;
  const double moment = of == LeastOf::torque ? inertia.norm() : 1.0, power = of_jerk ? h * h * h * h * h : h * h * h;
  const double turn =
      power / moment * (momentum(of, inertia, piece, h, 1.0) - momentum(of, inertia, piece, h, 0.0)).norm();
  if (turn < rounding_of_turns) return 0.0;
  return (of_jerk ? scale_of_jerk_excess : scale_of_excess) * turn * turn * moment * moment / power;
}

/// Twice as many pieces in the intervals whose excess counts beside the whole energy; empty where none does.
std::vector<std::size_t> refined(const std::vector<std::size_t>& counts, const std::vector<double>& excesses,
                                 double energy) {
  const double allowed = excess_share * energy;
  if (!(std::accumulate(excesses.begin(), excesses.end(), 0.0) > allowed)) return {};
  std::vector<std::size_t> more = counts;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (excesses[i] * static_cast<double>(counts.size()) > allowed && counts[i] < most_pieces) more[i] *= 2;
  return more == counts ? std::vector<std::size_t>() : more;
}

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
  const auto rates = [](const LeastNode& n) {
    return std::array<Eigen::Vector3d, 3>{n.rates.head<3>(), n.rates.tail<3>(), Eigen::Vector3d::Zero()};
  };
  return hermite_piece_about_middle(from.orientation, problem.increment_after(node), rates(from), rates(to),
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
  for (const Parameter& of_auto : Auto::parameters) with.parameters.emplace(of_auto.name, PerKey({of_auto.initial}));
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

using PathDerivatives = HermitePath<5>::Derivatives;

bool rests(const End& end) { return end.rule == EndRule::rest; }

/// The derivatives of orders 1 … P-1 at the positions that make ∫|p^(P)|² least, a row for each order.
template <int P>
std::vector<Eigen::Matrix<double, P - 1, 3>> least_derivatives(const Knots& knots,
                                                               std::span<const Eigen::Vector3d> positions,
                                                               const FamilySettings& settings) {
  using Chain = ChainElimination<P - 1, 0, 3, P>;
  const std::size_t last = knots.segments();
  Chain chain;
  chain.start(positions.size());
  for (std::size_t i = 0; i <= last; ++i) {
    typename Chain::Low low = Chain::Low::Zero();
    if (i < last) {
      const auto link = scalar_link<P>(knots.span(i).step());
      low.template leftCols<P - 1>() = link.template middleCols<P - 1>(1);
      low.template middleCols<P - 1>(P - 1) = link.template rightCols<P - 1>();
      low.template rightCols<3>() = -link.col(P) * (positions[i + 1] - positions[i]).transpose();
    }
    if ((i == 0 && rests(settings.start)) || (i == last && rests(settings.end))) {
      low.col(0).setZero();
      chain.fix(0);
    }
    if (i + 1 == last && rests(settings.end)) low.col(P - 1).setZero();
    static_cast<void>(chain.add(low));
  }
  std::vector<Eigen::Matrix<double, P - 1, 3>> derivatives(positions.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    chain.solve(Eigen::Vector3d::Unit(axis), [&](std::size_t i, const auto& x) { derivatives[i].col(axis) = x; });
  return derivatives;
}

/// p̈ of the cubic on a segment at its start and at its end.
std::array<Eigen::Vector3d, 2> bends(const Eigen::Vector3d& chord, const Eigen::Vector3d& leaving,
                                     const Eigen::Vector3d& arriving, double h) {
  const Eigen::Vector3d slope = chord / h;
  return {(6.0 * slope - 4.0 * leaving - 2.0 * arriving) / h, (2.0 * leaving + 4.0 * arriving - 6.0 * slope) / h};
}

/// The cubics as quintics. Both segments beside a key bend alike there; that of the longer one is rounded less.
std::vector<PathDerivatives> cubic_derivatives(const Knots& knots, std::span<const Eigen::Vector3d> positions,
                                               const FamilySettings& settings) {
  const auto velocities = least_derivatives<2>(knots, positions, settings);
  std::vector<PathDerivatives> derivatives;
  for (const auto& v : velocities) derivatives.push_back({v.row(0).transpose(), Eigen::Vector3d::Zero()});
  double before = 0.0;
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const double h = knots.span(i).step();
    const auto [start, end] = bends(positions[i + 1] - positions[i], derivatives[i][0], derivatives[i + 1][0], h);
    if (h > before) derivatives[i][1] = start;
    derivatives[i + 1][1] = end;
    before = h;
  }
  return derivatives;
}

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

Expected<HermitePath<5>> Least::path(const Keyframes& keys, const FamilySettings& settings) {
  Knots knots = key_knots(keys);
  const auto positions = keys.positions();
  std::vector<PathDerivatives> derivatives;
  if (settings.choice("energy") == "jerk") {
    for (const auto& d : least_derivatives<3>(knots, positions, settings))
      derivatives.push_back({d.row(0).transpose(), d.row(1).transpose()});
  } else {
    derivatives = cubic_derivatives(knots, positions, settings);
  }
  return HermitePath<5>(std::move(knots), {positions.begin(), positions.end()}, std::move(derivatives));
}

}}}  // namespace orispline::families
