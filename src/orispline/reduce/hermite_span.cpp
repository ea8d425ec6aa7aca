// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/hermite_span.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A span of more targets is fitted to some of them, and looked at in all.
constexpr std::size_t most_fitted = 4096;

Eigen::Quaterniond turn_between(const Eigen::Vector4d& from, const Eigen::Vector4d& to) {
  return Eigen::Quaterniond(from).conjugate() * Eigen::Quaterniond(to);
}

/// A symmetric matrix, given by xx, yy, zz, xy, xz, yz.
Eigen::Matrix3d matrix(const Eigen::Array<double, 6, 1>& s) {
  return Eigen::Matrix3d{{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}};
}
Eigen::Vector3d times(const Eigen::Array<double, 6, 1>& s, const Eigen::Vector3d& v) {
  return {s[0] * v.x() + s[3] * v.y() + s[4] * v.z(), s[3] * v.x() + s[1] * v.y() + s[5] * v.z(),
          s[4] * v.x() + s[5] * v.y() + s[2] * v.z()};
}

}  // namespace

template <CurvePoint P>
HermiteSpan<P>::HermiteSpan(const CubicTargets<P>& targets, std::size_t i, std::size_t j, bool is_bound)
    : targets_(targets),
      first_(i),
      last_(j),
      every_((j - i) / most_fitted + 1),
      is_bound_(is_bound),
      length_(targets.times[j] - targets.times[i]) {
  if constexpr (std::same_as<P, Eigen::Quaterniond>) {
    turn_ = log<double>(turn_between(targets.points[i], targets.points[j]));
    to_chart_ = right_jacobian_inverse<double>(turn_);
  } else {
    turn_ = targets.points[j] - targets.points[i];
  }
  terms_.reserve((j - i) / every_);
  for (std::size_t k = i + every_; k < j; k += every_) terms_.push_back(term_of(k));
}

template <CurvePoint P>
typename HermiteSpan<P>::Term HermiteSpan<P>::term_of(std::size_t target) const {
  const HermiteBasis basis = basis_at(target);
  Term term{.first = length_ * basis.leaving,
            .last = length_ * basis.arriving,
            .rest = -basis.end * turn_,
            .metric = {1.0, 1.0, 1.0, 0.0, 0.0, 0.0},
            .right = {}};
  if constexpr (std::same_as<P, Eigen::Quaterniond>) {
    const Eigen::Quaterniond turn = turn_between(targets_.points[first_], targets_.points[target]);
    const Eigen::Vector3d there = log<double>(turn);
    term.rest += there;
    if (const double square = there.squaredNorm(); square > 1e-8) {
      const double across = 4.0 * turn.vec().squaredNorm() / square;  // (sin(θ/2) / (θ/2))²
      const Eigen::Vector3d &n = there, along = ((1.0 - across) / square) * n;
      term.metric = {across + along.x() * n.x(), across + along.y() * n.y(), across + along.z() * n.z(),
                     along.x() * n.y(),          along.x() * n.z(),          along.y() * n.z()};
    }
  } else {
    term.rest += targets_.points[target] - targets_.points[first_];
  }
  term.right = times(term.metric, term.rest);
  return term;
}

template <CurvePoint P>
void HermiteSpan<P>::reset_weights() {
  for (Term& term : terms_) term.weight = 1.0;
}

template <CurvePoint P>
HermiteEquations HermiteSpan<P>::equations() const {
  Symmetric first = Symmetric::Zero(), mixed = Symmetric::Zero(), last = Symmetric::Zero();
  HermiteEquations sum;
  for (const Term& term : terms_) {
    const double of_first = term.weight * term.first, of_last = term.weight * term.last;
    first += of_first * term.first * term.metric;
    mixed += of_first * term.last * term.metric;
    last += of_last * term.last * term.metric;
    sum.right_first += of_first * term.right;
    sum.right_last += of_last * term.right;
  }
  sum.first = matrix(first);
  sum.mixed = matrix(mixed) * to_chart_;
  sum.last = to_chart_.transpose() * matrix(last) * to_chart_;
  sum.right_last = to_chart_.transpose() * sum.right_last;
  return sum;
}

template <CurvePoint P>
double HermiteSpan<P>::measure(const Eigen::Vector3d& rate_first, const Eigen::Vector3d& rate_last) {
  if (!is_bound_) return 0.0;
  constexpr double unit = std::same_as<P, Eigen::Quaterniond> ? 0.25 : 1.0;
  const Eigen::Vector3d last = to_chart_ * rate_last;
  double largest = 0.0;
  for (Term& term : terms_) {
    const Eigen::Vector3d off = term.first * rate_first + term.last * last - term.rest;
    largest = std::max(largest, term.miss = unit * off.dot(times(term.metric, off)));
  }
  return largest;
}

template <CurvePoint P>
bool HermiteSpan<P>::holds(const Eigen::Vector3d& rate_first, const Eigen::Vector3d& rate_last,
                           double square_bound) const {
  if (!is_bound_) return true;
  const Eigen::Vector3d last = to_chart_ * rate_last;
  const auto square_miss = [&](std::size_t k) {
    const HermiteBasis basis = basis_at(k);
    const Eigen::Vector3d there = basis.end * turn_ + length_ * (basis.leaving * rate_first + basis.arriving * last);
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      return (turn_between(targets_.points[k], targets_.points[first_]) * exp<double>(there)).vec().squaredNorm();
    else return (targets_.points[first_] + there - targets_.points[k]).squaredNorm();
  };
  for (std::size_t k = first_ + 1; k < last_; ++k)
    if (!(square_miss(k) <= square_bound)) return false;
  return true;
}

template <CurvePoint P>
void HermiteSpan<P>::weigh(double largest) {
  for (Term& term : terms_)
    term.weight = std::max(term.weight * (is_bound_ ? std::sqrt(term.miss / largest) : 0.3), 1e-9);
}

template class HermiteSpan<Eigen::Quaterniond>;
template class HermiteSpan<Eigen::Vector3d>;

}}  // namespace orispline
