// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/hermite_span.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

constexpr int rounds_of_rates = 8;

/// The rows of the equations for the free rates.
class RateEquations {
 public:
  explicit RateEquations(std::size_t rates)
      : diagonal_(rates, Eigen::Matrix3d::Zero()),
        above_(rates, Eigen::Matrix3d::Zero()),
        right_(rates, Eigen::Vector3d::Zero()) {}

  void add(std::size_t span, const HermiteEquations& more) {
    diagonal_[span] += more.first;
    above_[span] += more.mixed;
    diagonal_[span + 1] += more.last;
    right_[span] += more.right_first;
    right_[span + 1] += more.right_last;
  }

  /// The rates from `first` up to `end`; those outside stay.
  void solve(std::span<Eigen::Vector3d> rates, std::size_t first, std::size_t end) {
    if (first > 0 && first < end) right_[first] -= above_[first - 1].transpose() * rates[first - 1];
    if (end < rates.size() && first < end) right_[end - 1] -= above_[end - 1] * rates[end];
    for (std::size_t i = first; i < end; ++i) {
      diagonal_[i].diagonal().array() += 1e-12 * diagonal_[i].trace() + 1e-300;
      if (i > first) {
        const Eigen::Matrix3d factor = above_[i - 1].transpose() * diagonal_[i - 1];
        diagonal_[i] -= factor * above_[i - 1];
        right_[i] -= factor * right_[i - 1];
      }
      diagonal_[i] = diagonal_[i].inverse().eval();
    }
    for (std::size_t i = end; i-- > first;) {
      Eigen::Vector3d rest = right_[i];
      if (i + 1 < end) rest -= above_[i] * rates[i + 1];
      rates[i] = diagonal_[i] * rest;
    }
  }

 private:
  std::vector<Eigen::Matrix3d> diagonal_, above_;  ///< above_[i]: of rate i + 1 in row i
  std::vector<Eigen::Vector3d> right_;
};

template <CurvePoint P>
double measure(std::span<HermiteSpan<P>* const> spans, std::span<const Eigen::Vector3d> rates) {
  double largest = 0.0;
  for (std::size_t k = 0; k < spans.size(); ++k) largest = std::max(largest, spans[k]->measure(rates[k], rates[k + 1]));
  return largest;
}

template <CurvePoint P>
bool hold(std::span<HermiteSpan<P>* const> spans, std::span<const Eigen::Vector3d> rates, double square_bound) {
  for (std::size_t k = 0; k < spans.size(); ++k)
    if (!spans[k]->holds(rates[k], rates[k + 1], square_bound)) return false;
  return true;
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

template <CurvePoint P>
void fit_rates(std::span<HermiteSpan<P>* const> spans, std::span<Eigen::Vector3d> rates, FreeEnds free) {
  RateEquations equations(rates.size());
  for (std::size_t k = 0; k < spans.size(); ++k) equations.add(k, spans[k]->equations());
  equations.solve(rates, free.first ? 0 : 1, free.last ? rates.size() : rates.size() - 1);
}

template <CurvePoint P>
bool find_rates(std::span<HermiteSpan<P>* const> spans, std::span<Eigen::Vector3d> rates, FreeEnds free,
                double square_bound) {
  for (HermiteSpan<P>* span : spans) span->reset_weights();
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round <= rounds_of_rates; ++round) {
    fit_rates(spans, rates, free);
    const double largest = measure<P>(spans, rates);
    if (largest <= square_bound && hold<P>(spans, rates, square_bound)) return true;
    if (!(largest <= beyond_weights * beyond_weights * square_bound)) return false;
    if (round > 2 && largest > 0.98 * before) return false;
    before = largest;
    for (HermiteSpan<P>* span : spans) span->weigh(largest);
  }
  return false;
}

template void fit_rates(std::span<HermiteSpan<Eigen::Quaterniond>* const>, std::span<Eigen::Vector3d>, FreeEnds);
template void fit_rates(std::span<HermiteSpan<Eigen::Vector3d>* const>, std::span<Eigen::Vector3d>, FreeEnds);
template bool find_rates(std::span<HermiteSpan<Eigen::Quaterniond>* const>, std::span<Eigen::Vector3d>, FreeEnds,
                         double);
template bool find_rates(std::span<HermiteSpan<Eigen::Vector3d>* const>, std::span<Eigen::Vector3d>, FreeEnds, double);

}}  // namespace orispline
