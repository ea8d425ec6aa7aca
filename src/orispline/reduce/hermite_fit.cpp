// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/hermite_fit.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

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
