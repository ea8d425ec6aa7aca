// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/cubic_span.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/curve/key_check.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int rounds_of_radii = 3, rounds_of_directions = 2, rounds_of_weights = 10, rounds_of_nearest = 6;
/// Lengths of the polynomial of a quaternion at its targets: readers that do not normalise at once shall not see
/// others.
constexpr double shortest_radius = 0.5, longest_radius = 2.0;
/// What a radius that is off 1 weighs beside a direction that is off as much.
constexpr double weight_of_radius = 1e-4;
/// A span of more targets is first tried with some of them: where these cannot be held, all cannot.
constexpr std::size_t most_at_once = 2048;

/// The square of half the angle's sine between the direction of p and a unit quaternion q, times |p|².
double square_miss(const Eigen::Vector4d& p, const Eigen::Vector4d& q) { return (p - p.dot(q) * q).squaredNorm(); }

/// The square of what a polynomial misses a target by, in the terms of the tolerance: for a direction, half the angle's
/// sine.
double miss_of(const Eigen::Vector4d& p, const Eigen::Vector4d& q) {
  const double radius = p.dot(q);
  const bool is_sound = radius > shortest_radius && radius < longest_radius;
  return is_sound ? square_miss(p, q) / p.squaredNorm() : 1.0;
}
double miss_of(const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return (p - q).squaredNorm(); }

}  // namespace

/// One span's targets between its ends, and tangents for them that become better by the round.
template <CurvePoint P>
class CubicSpans<P>::Fit {
 public:
  /// Of every so many-th target.
  Fit(const CubicTargets<P>& targets, std::size_t i, std::size_t j, const GivenTangents<P>& given, std::size_t every)
      : targets_(targets),
        first_(i),
        every_(every),
        step_(targets.times[j] - targets.times[i]),
        given_(given),
        terms_((j - i - 1) / every) {
    const Components<P>&start = targets.points[i], &end = targets.points[j];
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const HermiteBasis basis = hermite_basis((targets.times[i + (k + 1) * every] - targets.times[i]) / step_);
      terms_[k] = {{basis.leaving, basis.arriving}, basis.start * start + basis.end * end, 1.0, 1.0};
      if (given.leaving) give(terms_[k], 0, *given.leaving);
      if (given.arriving) give(terms_[k], 1, *given.arriving);
    }
  }

  /// Solves for the tangents, and returns the largest square miss.
  double solve() {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Matrix<double, 2, size> right = Eigen::Matrix<double, 2, size>::Zero();
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const Term& term = terms_[k];
      const Components<P> rest = term.radius * point(k) - term.fixed;
      normal += term.weight * term.basis * term.basis.transpose();
      right += term.weight * term.basis * rest.transpose();
    }
    // One target between is met exactly by the smallest tangents; a given one has no basis.
    tangents_ = terms_.size() > 1 && !given_.any() ? Solution(normal.inverse() * right)
                                                   : Solution(right / std::max(normal.trace(), 1e-300));
    return measured();
  }

  /// Solves for all components of both tangents at once so that the directions are right, whatever the radii but for
  /// a small weight, and returns the largest square miss.
  double solve_directions() {
    using Part = Eigen::Matrix<double, size, size>;
    using Square = Eigen::Matrix<double, 2 * size, 2 * size>;
    Square normal = Square::Zero();
    Eigen::Matrix<double, 2 * size, 1> right = Eigen::Matrix<double, 2 * size, 1>::Zero();
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const Term& term = terms_[k];
      const Components<P> p = term.fixed + tangents_.transpose() * term.basis, &q = point(k);
      const double weight = term.weight / std::max(p.squaredNorm(), shortest_radius * shortest_radius);
      const Part counted = Part::Identity() - (1.0 - weight_of_radius) * q * q.transpose();
      const Components<P> miss = weight * (counted * (q - p));
      const Eigen::Vector2d& basis = term.basis;
      normal.template topLeftCorner<size, size>() += weight * basis[0] * basis[0] * counted;
      normal.template bottomLeftCorner<size, size>() += weight * basis[0] * basis[1] * counted;
      normal.template bottomRightCorner<size, size>() += weight * basis[1] * basis[1] * counted;
      right.template head<size>() += basis[0] * miss;
      right.template tail<size>() += basis[1] * miss;
    }
    normal.diagonal().array() += 1e-9 * normal.trace();
    const Eigen::Matrix<double, 2 * size, 1> step = normal.template selfadjointView<Eigen::Lower>().ldlt().solve(right);
    tangents_.row(0) += step.template head<size>();
    tangents_.row(1) += step.template tail<size>();
    return measured();
  }

  /// Every target's weight by its miss, as against the largest.
  void weigh(double largest) {
    for (Term& term : terms_) term.weight = std::max(term.weight * std::sqrt(term.miss / largest), 1e-9);
  }

  [[nodiscard]] CubicTangents<P> tangents() const {
    return {given_.leaving.value_or(Components<P>(tangents_.row(0)) / step_),
            given_.arriving.value_or(Components<P>(tangents_.row(1)) / step_)};
  }

 private:
  static constexpr int size = Components<P>::RowsAtCompileTime;
  using Solution = Eigen::Matrix<double, 2, size>;
  struct Term {
    Eigen::Vector2d basis;  ///< of the two tangents, times the span's length
    Components<P> fixed;    ///< what the ends alone give
    double radius, weight;
    double miss = 0.0;  ///< square
  };

  /// What a given tangent makes of a target is fixed.
  void give(Term& term, Eigen::Index side, const Components<P>& tangent) {
    term.fixed += term.basis[side] * step_ * tangent;
    term.basis[side] = 0.0;
  }

  [[nodiscard]] const Components<P>& point(std::size_t k) const { return targets_.points[first_ + (k + 1) * every_]; }

  double measured() {
    double largest = 0.0;
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      Term& term = terms_[k];
      const Components<P> p = term.fixed + tangents_.transpose() * term.basis;
      if constexpr (std::same_as<P, Eigen::Quaterniond>) term.radius = p.dot(point(k));
      term.miss = miss_of(p, point(k));
      largest = std::max(largest, term.miss);
    }
    return largest;
  }

  const CubicTargets<P>& targets_;
  std::size_t first_, every_;
  double step_;
  GivenTangents<P> given_;
  std::vector<Term> terms_;
  Solution tangents_ = Solution::Zero();
};

template <CurvePoint P>
CubicSpans<P>::CubicSpans(const CubicTargets<P>& targets, double tolerance) : targets_(targets) {
  const bool is_angle = std::same_as<P, Eigen::Quaterniond>;
  const double bound = is_angle ? elementary::sine_cosine(0.5 * std::min(tolerance, 3.0)).sine : tolerance;
  square_bound_ = bound * bound;
}

template <CurvePoint P>
std::optional<CubicTangents<P>> CubicSpans<P>::within(std::size_t i, std::size_t j,
                                                      const GivenTangents<P>& given) const {
  if (j == i + 1) return nearest(i, j, given);
  if constexpr (std::same_as<P, Eigen::Quaterniond>)  // readers may turn the other way by nearly 180°, and do by more
    if (targets_.points[i].dot(targets_.points[j]) < cosine_near_half_turn) return std::nullopt;
  if (const std::size_t every = (j - i) / (most_at_once / 2); j - i > most_at_once) {
    auto of_some = within(i, j, given, every);
    if (!of_some || holds(i, j, *of_some)) return of_some;
  }
  return within(i, j, given, 1);
}

template <CurvePoint P>
std::optional<CubicTangents<P>> CubicSpans<P>::within(std::size_t i, std::size_t j, const GivenTangents<P>& given,
                                                      std::size_t every) const {
  Fit fit(targets_, i, j, given, every);
  double largest = 0.0, before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds_of_radii; ++round) {
    largest = fit.solve();
    if (largest <= square_bound_) return fit.tangents();
  }
  if constexpr (std::same_as<P, Eigen::Quaterniond>)
    for (int round = 0; round < rounds_of_directions && j - i > 4; ++round) {
      largest = fit.solve_directions();
      if (largest <= square_bound_) return fit.tangents();
    }
  for (int round = 0; round < rounds_of_weights; ++round) {
    if (!(largest <= beyond_weights * beyond_weights * square_bound_)) break;
    fit.weigh(largest);
    before = largest;
    if constexpr (std::same_as<P, Eigen::Quaterniond>) largest = fit.solve_directions();
    else largest = fit.solve();
    if (largest <= square_bound_) return fit.tangents();
    if (round > 2 && largest > 0.98 * before) break;
  }
  return std::nullopt;
}

template <CurvePoint P>
bool CubicSpans<P>::holds(std::size_t i, std::size_t j, const CubicTangents<P>& tangents) const {
  const double h = targets_.times[j] - targets_.times[i];
  const Components<P>&start = targets_.points[i], &end = targets_.points[j];
  for (std::size_t k = i + 1; k < j; ++k) {
    const HermiteBasis basis = hermite_basis((targets_.times[k] - targets_.times[i]) / h);
    const Components<P> p = basis.start * start + basis.end * end +
                            h * (basis.leaving * tangents.leaving + basis.arriving * tangents.arriving);
    if (!(miss_of(p, targets_.points[k]) <= square_bound_)) return false;
  }
  return true;
}

template <CurvePoint P>
CubicTangents<P> CubicSpans<P>::nearest(std::size_t i, std::size_t j, const GivenTangents<P>& given) const {
  if (j == i + 1) {
    const Components<P> rate = (targets_.points[j] - targets_.points[i]) / (targets_.times[j] - targets_.times[i]);
    return {given.leaving.value_or(rate), given.arriving.value_or(rate)};
  }
  Fit fit(targets_, i, j, given, 1);
  double least = 0.0;
  for (int round = 0; round < rounds_of_radii; ++round) least = fit.solve();
  CubicTangents<P> best = fit.tangents();
  if constexpr (std::same_as<P, Eigen::Quaterniond>)
    for (int round = 0; round < rounds_of_nearest && j - i > 2 && least > square_bound_; ++round)
      if (const double miss = fit.solve_directions(); miss < least) least = miss, best = fit.tangents();
  return best;
}

template class CubicSpans<Eigen::Quaterniond>;
template class CubicSpans<Eigen::Vector3d>;

}}  // namespace orispline
