// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/cubic_span.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/curve/key_check.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

template <CurvePoint P>
constexpr bool has_radii = std::same_as<P, Eigen::Quaterniond>;  ///< the lengths of its polynomial are free
template <CurvePoint P>
constexpr int rounds_of_radii = has_radii<P> ? 3 : 1;
constexpr int rounds_of_directions = 2, rounds_of_weights = 10, rounds_of_nearest = 6;
/// Lengths of the polynomial of a quaternion at its targets: readers that do not normalise at once shall not see
/// others.
constexpr double shortest_radius = 0.5, longest_radius = 2.0;
/// What a radius that is off 1 weighs beside a direction that is off as much.
constexpr double weight_of_radius = 1e-4;
/// A span is first tried with some of its targets: where these cannot be held, all cannot. Of a long one all may be
/// held by what holds these.
constexpr std::size_t few_at_first = 10, least_stride = 3, most_at_once = 2048;
/// By how much the least that targets can be missed by may be told too large, since directions are not linear.
constexpr double doubt = 1.05;

/// The square of half the angle's sine between the direction of p and a unit quaternion q, times |p|².
double square_miss(const Eigen::Vector4d& p, const Eigen::Vector4d& q) { return (p - p.dot(q) * q).squaredNorm(); }

/// The square of what a polynomial misses a target by, in the terms of the tolerance: for a direction, half the angle's
/// sine; with a radius that readers shall not see, 1.
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
      terms_[k] = {.basis = {basis.leaving, basis.arriving}, .fixed = basis.start * start + basis.end * end};
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
    Unknowns right = Unknowns::Zero();
    Products of_first = Products::Zero(), mixed = Products::Zero(), of_last = Products::Zero();
    double first = 0.0, both = 0.0, last = 0.0;
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const Term& term = terms_[k];
      const Components<P>&p = term.point, &q = point(k);
      const double weight = term.weight / std::max(p.squaredNorm(), shortest_radius * shortest_radius);
      const double leaving = weight * term.basis[0], arriving = weight * term.basis[1];
      const Components<P> off = q - p, miss = off - (1.0 - weight_of_radius) * q.dot(off) * q;
      const Products products = products_of(q);
      first += leaving * term.basis[0];
      both += leaving * term.basis[1];
      last += arriving * term.basis[1];
      of_first += leaving * term.basis[0] * products;
      mixed += leaving * term.basis[1] * products;
      of_last += arriving * term.basis[1] * products;
      right.template head<size>() += leaving * miss;
      right.template tail<size>() += arriving * miss;
    }
    Square normal;
    normal.template topLeftCorner<size, size>() = across(first, of_first);
    normal.template bottomLeftCorner<size, size>() = across(both, mixed);
    normal.template bottomRightCorner<size, size>() = across(last, of_last);
    normal.diagonal().array() += 1e-9 * normal.trace();
    solve_in_place(normal, right);
    tangents_.row(0) += right.template head<size>();
    tangents_.row(1) += right.template tail<size>();
    return measured();
  }

  /// Every target's weight by its miss, as against the largest.
  void weigh(double largest) {
    for (Term& term : terms_) term.weight = std::max(term.weight * std::sqrt(term.miss / largest), 1e-9);
  }

  /// The mean square miss of the targets by their weights. After a solution by least squares no tangents have a smaller
  /// one, and so none a smaller largest miss.
  [[nodiscard]] double least_largest() const {
    double sum = 0.0, weights = 0.0;
    for (const Term& term : terms_) sum += term.weight * term.miss, weights += term.weight;
    return sum / weights;
  }

  [[nodiscard]] CubicTangents<P> tangents() const {
    return {given_.leaving.value_or(Components<P>(tangents_.row(0)) / step_),
            given_.arriving.value_or(Components<P>(tangents_.row(1)) / step_)};
  }

 private:
  static constexpr int size = Components<P>::RowsAtCompileTime, pairs = size * (size + 1) / 2;
  using Solution = Eigen::Matrix<double, 2, size>;
  using Square = Eigen::Matrix<double, 2 * size, 2 * size>;
  using Unknowns = Eigen::Matrix<double, 2 * size, 1>;
  using Products = Eigen::Array<double, pairs, 1>;  ///< of two components each: xx, xy, …, yy, …
  struct Term {
    Eigen::Vector2d basis;                          ///< of the two tangents, times the span's length
    Components<P> fixed;                            ///< what the ends alone give
    Components<P> point = Components<P>::Zero();    ///< of the polynomial
    double radius = 1.0, weight = 1.0, miss = 0.0;  ///< miss: square
  };

  /// What a given tangent makes of a target is fixed.
  void give(Term& term, Eigen::Index side, const Components<P>& tangent) {
    term.fixed += term.basis[side] * step_ * tangent;
    term.basis[side] = 0.0;
  }

  [[nodiscard]] const Components<P>& point(std::size_t k) const { return targets_.points[first_ + (k + 1) * every_]; }

  static Products products_of(const Components<P>& q) {
    Products products;
    for (int row = 0, k = 0; row < size; ++row)
      for (int column = row; column < size; ++column) products[k++] = q[row] * q[column];
    return products;
  }

  /// A sum of squares less nearly all of what lies along the targets.
  static Eigen::Matrix<double, size, size> across(double sum, const Products& along) {
    Eigen::Matrix<double, size, size> part;
    for (int row = 0, k = 0; row < size; ++row)
      for (int column = row; column < size; ++column, ++k)
        part(row, column) = part(column, row) = (row == column ? sum : 0.0) - (1.0 - weight_of_radius) * along[k];
    return part;
  }

  /// By Cholesky's factors of a positive definite matrix, of which the lower half is given, and is overwritten.
  static void solve_in_place(Square& a, Unknowns& x) {
    for (int column = 0; column < 2 * size; ++column) {
      for (int k = 0; k < column; ++k)
        for (int row = column; row < 2 * size; ++row) a(row, column) -= a(row, k) * a(column, k);
      const double inverse = 1.0 / std::sqrt(std::max(a(column, column), 1e-300));
      for (int row = column; row < 2 * size; ++row) a(row, column) *= inverse;
    }
    for (int row = 0; row < 2 * size; ++row) {
      for (int k = 0; k < row; ++k) x[row] -= a(row, k) * x[k];
      x[row] /= a(row, row);
    }
    for (int row = 2 * size; row-- > 0;) {
      for (int k = row + 1; k < 2 * size; ++k) x[row] -= a(k, row) * x[k];
      x[row] /= a(row, row);
    }
  }

  double measured() {
    double largest = 0.0;
    const Components<P> leaving = tangents_.row(0), arriving = tangents_.row(1);
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      Term& term = terms_[k];
      term.point = term.fixed + term.basis[0] * leaving + term.basis[1] * arriving;
      if constexpr (has_radii<P>) term.radius = term.point.dot(point(k));
      term.miss = miss_of(term.point, point(k));
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
  if (const std::size_t every = (j - i) / few_at_first; every >= least_stride && !within(i, j, given, every))
    return std::nullopt;
  if (const std::size_t every = (j - i) / (most_at_once / 2); j - i > most_at_once) {
    auto of_some = within(i, j, given, every);
    if (!of_some || holds(i, j, *of_some)) return of_some;
  }
  return within(i, j, given, 1);
}

template <CurvePoint P>
std::optional<CubicTangents<P>> CubicSpans<P>::within(std::size_t i, std::size_t j, const GivenTangents<P>& given,
                                                      std::size_t every) const {
  constexpr double unsound = has_radii<P> ? 1.0 : std::numeric_limits<double>::infinity();
  Fit fit(targets_, i, j, given, every);
  double largest = 0.0, before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds_of_radii<P>; ++round) {
    largest = fit.solve();
    if (largest <= square_bound_) return fit.tangents();
  }
  bool is_least = !has_radii<P>;
  if constexpr (has_radii<P>)
    for (int round = 0; round < rounds_of_directions && j - i > 4; ++round) {
      largest = fit.solve_directions();
      is_least = true;
      if (largest <= square_bound_) return fit.tangents();
    }
  for (int round = 0; round < rounds_of_weights; ++round) {
    if (!(largest <= beyond_weights * beyond_weights * square_bound_)) break;
    if (is_least && largest < unsound && fit.least_largest() > doubt * square_bound_) break;
    is_least = true;
    fit.weigh(largest);
    before = largest;
    if constexpr (has_radii<P>) largest = fit.solve_directions();
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
  for (int round = 0; round < rounds_of_radii<P>; ++round) least = fit.solve();
  CubicTangents<P> best = fit.tangents();
  if constexpr (std::same_as<P, Eigen::Quaterniond>)
    for (int round = 0; round < rounds_of_nearest && j - i > 2 && least > square_bound_; ++round)
      if (const double miss = fit.solve_directions(); miss < least) least = miss, best = fit.tangents();
  return best;
}

template class CubicSpans<Eigen::Quaterniond>;
template class CubicSpans<Eigen::Vector3d>;

}}  // namespace orispline
