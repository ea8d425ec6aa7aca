// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_trace.hpp>

#include <cmath>
#include <numeric>

#include <orispline/math/chain_covariance.hpp>
#include <orispline/math/scalar_link.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The eliminated chain of the scalar smoother.
template <int P, int Data>
ChainElimination<P, Data, 1> eliminated(const ScalarSmoother& smoother) {
  using Chain = ChainElimination<P, Data, 1>;
  Chain chain;
  chain.start(smoother.times.size());
  for (std::size_t i = 0; i < smoother.times.size(); ++i) {
    typename Chain::Low low = Chain::Low::Zero();
    low(0, 0) = std::sqrt(smoother.weights[i]);
    if constexpr (Data == 2) low(1, 1) = std::sqrt(smoother.rate_weights[i]);
    if (i + 1 < smoother.times.size()) low.template bottomLeftCorner<P, 2 * P>() = smoother.template link<P>(i);
    static_cast<void>(chain.add(low));
  }
  return chain;
}

/// With a bias that drifts as one more unknown of every node.
template <int P>
ChainElimination<P + 1, 2, 1> eliminated_with_drift(const ScalarSmoother& smoother) {
  using Chain = ChainElimination<P + 1, 2, 1>;
  Chain chain;
  chain.start(smoother.times.size());
  for (std::size_t i = 0; i < smoother.times.size(); ++i) {
    typename Chain::Low low = Chain::Low::Zero();
    const double rate_root = std::sqrt(smoother.rate_weights[i]);
    low(0, 0) = std::sqrt(smoother.weights[i]);
    low(1, 1) = rate_root;
    low(1, P) = -rate_root;
    if (i + 1 < smoother.times.size()) {
      const Eigen::Matrix<double, P, 2 * P> link = smoother.template link<P>(i);
      low.template block<P, P>(2, 0) = link.template leftCols<P>();
      low.template block<P, P>(2, P + 1) = link.template rightCols<P>();
      const double walk_root = 1.0 / (smoother.drift * std::sqrt(smoother.times[i + 1] - smoother.times[i]));
      low(2 + P, P) = -walk_root;
      low(2 + P, 2 * P + 1) = walk_root;
    }
    static_cast<void>(chain.add(low));
  }
  return chain;
}

template <int P>
std::vector<double> variances(const ScalarSmoother& smoother) {
  std::vector<double> result(smoother.times.size());
  const auto take = [&](std::size_t i, const auto& covariance, const auto&) { result[i] = covariance(0, 0); };
  if (smoother.rate_weights.empty()) for_each_covariance(eliminated<P, 1>(smoother), take);
  else if (smoother.drift > 0.0) for_each_covariance(eliminated_with_drift<P>(smoother), take);
  else for_each_covariance(eliminated<P, 2>(smoother), take);
  return result;
}

template <int P>
std::vector<double> freedoms(const ScalarSmoother& smoother) {
  std::vector<double> result(smoother.times.size() - 1);
  Eigen::Matrix<double, P, P> next;
  for_each_covariance(eliminated<P, 1>(smoother), [&](std::size_t i, const auto& covariance, const auto& gain) {
    if (i < result.size()) {
      Eigen::Matrix<double, 2 * P, 2 * P> both;
      both << covariance, -gain * next, -(gain * next).transpose(), next;
      const Eigen::Matrix<double, P, 2 * P> link = smoother.template link<P>(i);
      result[i] = P - (link * both * link.transpose()).trace();
    }
    next = covariance;
  });
  return result;
}

}  // namespace

template <int P>
Eigen::Matrix<double, P, 2 * P> ScalarSmoother::link(std::size_t interval) const {
  const double share = relative_lambdas.empty() ? 1.0 : relative_lambdas[interval];
  return std::sqrt(lambda * share) * scalar_link<P>(times[interval + 1] - times[interval]);
}

std::vector<double> node_variances(const ScalarSmoother& smoother) {
  return smoother.penalty == Penalty::acceleration ? variances<2>(smoother) : variances<3>(smoother);
}

std::vector<double> interval_freedoms(const ScalarSmoother& smoother) {
  return smoother.penalty == Penalty::acceleration ? freedoms<2>(smoother) : freedoms<3>(smoother);
}

double hat_trace(const ScalarSmoother& smoother) {
  const std::vector<double> variances = node_variances(smoother);
  return std::inner_product(variances.begin(), variances.end(), smoother.weights.begin(), 0.0);
}

}}  // namespace orispline
