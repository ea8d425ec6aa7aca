// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_trace.hpp>

#include <cmath>
#include <numeric>

#include <orispline/math/chain_elimination.hpp>
#include <orispline/math/scalar_link.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

template <int P>
std::vector<double> variances(std::span<const double> times, std::span<const double> weights, double lambda) {
  using Chain = ChainElimination<P, 1, 1>;
  Chain chain;
  chain.start(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    typename Chain::Low low = Chain::Low::Zero();
    low(0, 0) = std::sqrt(weights[i]);
    if (i + 1 < times.size())
      low.template bottomLeftCorner<P, 2 * P>() = std::sqrt(lambda) * scalar_link<P>(times[i + 1] - times[i]);
    static_cast<void>(chain.add(low));
  }
  using Block = Eigen::Matrix<double, P, P>;
  Block covariance = Block::Zero();  // of the node behind
  std::vector<double> result(times.size());
  for (std::size_t i = times.size(); i-- > 0;) {
    const auto factor = chain.rows()[i].template leftCols<P>().template triangularView<Eigen::Upper>();
    const Block inverse = factor.solve(Block::Identity());
    const Block gain = factor.solve(Block(chain.rows()[i].template middleCols<P>(P)));
    covariance = (inverse * inverse.transpose() + gain * covariance * gain.transpose()).eval();
    result[i] = covariance(0, 0);
  }
  return result;
}

}  // namespace

std::vector<double> node_variances(std::span<const double> times, std::span<const double> weights, Penalty penalty,
                                   double lambda) {
  return penalty == Penalty::acceleration ? variances<2>(times, weights, lambda) : variances<3>(times, weights, lambda);
}

double hat_trace(std::span<const double> times, std::span<const double> weights, Penalty penalty, double lambda) {
  const std::vector<double> variances = node_variances(times, weights, penalty, lambda);
  return std::inner_product(variances.begin(), variances.end(), weights.begin(), 0.0);
}

}  // namespace orispline::inline ORISPLINE_ABI
