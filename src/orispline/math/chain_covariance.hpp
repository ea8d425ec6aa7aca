// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/math/chain_elimination.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The blocks of the covariance (RᵀR)⁻¹ of an eliminated chain about each node, from the last one to the first: calls
/// `take(node, covariance, gain)`. That of the node with the next one is -gain times the next one's covariance.
///
/// By the block recursion of Hutchinson and de Hoog (1985), which is that of Takahashi; linear time.
template <int M, int Data, int Sides, int Link, class Take>
void for_each_covariance(const ChainElimination<M, Data, Sides, Link>& chain, Take take) {
  using Block = Eigen::Matrix<double, M, M>;
  Block covariance = Block::Zero();  // of the node behind
  for (std::size_t i = chain.rows().size(); i-- > 0;) {
    const auto factor = chain.rows()[i].template leftCols<M>().template triangularView<Eigen::Upper>();
    // Large blocks column by column, and by lazy products, since their solutions and products as a whole have other
    // bits on other machines.
    constexpr Eigen::Index together = M <= 4 ? M : 1;
    Block inverse = Block::Identity(), gain = chain.rows()[i].template middleCols<M>(M);
    for (Eigen::Index k = 0; k < M; k += together) {
      factor.solveInPlace(inverse.template middleCols<together>(k));
      factor.solveInPlace(gain.template middleCols<together>(k));
    }
    const Block of_gain = gain.lazyProduct(covariance);
    covariance = inverse.lazyProduct(inverse.transpose()) + of_gain.lazyProduct(gain.transpose());
    take(i, covariance, gain);
  }
}

}}  // namespace orispline
