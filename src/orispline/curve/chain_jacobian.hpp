// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <orispline/math/eigen.hpp>
#include <orispline/math/jet.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace chain {

/// Takes the derivative of an equation by an unknown, entry (i, k) that of component i by component k; what is told of
/// the same two more than once adds up.
using TakeBlock = std::function<void(std::size_t equation, std::size_t unknown, const Eigen::Matrix3d& block)>;

/// An equation sees three unknowns with three components each.
using Dual9 = Dual<9>;
using DualSteps = std::vector<Vector3<Dual9>>;

/// The derivatives of a chain of equations, from its residual over duals: one pass, or two where the length of a loop
/// is no multiple of three.
void differentiate(std::size_t size, bool closed, const std::function<DualSteps(const DualSteps&)>& residual,
                   const TakeBlock& take);

/// The vector at `value` as three of a dual's variables, from the direction `first` on.
template <std::size_t N>
[[nodiscard]] Vector3<Dual<N>> variables(const Eigen::Vector3d& value, std::size_t first) {
  return {Dual<N>::variable(value.x(), first), Dual<N>::variable(value.y(), first + 1),
          Dual<N>::variable(value.z(), first + 2)};
}

/// The derivatives by those three.
template <std::size_t N>
[[nodiscard]] Eigen::Matrix3d derivatives(const Vector3<Dual<N>>& of, std::size_t first) {
  Eigen::Matrix3d block;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) block(i, static_cast<Eigen::Index>(k)) = of[i].slope[first + k];
  return block;
}

}}}  // namespace orispline::chain
