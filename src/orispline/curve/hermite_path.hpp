// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <orispline/curve/knots.hpp>
#include <orispline/curve/two_point_blending.hpp>
#include <orispline/math/bernstein.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Piecewise polynomial path of odd degree 2K+1 through positions with given derivatives of orders 1…K at the keys.
template <std::size_t Degree>
class HermitePath {
 public:
  static constexpr int degree = static_cast<int>(Degree);
  static constexpr std::size_t orders = (Degree - 1) / 2;
  using Derivatives = std::array<Eigen::Vector3d, orders>;  ///< [m/s], [m/s²], …

  HermitePath(Knots knots, std::vector<Eigen::Vector3d> positions, std::vector<Derivatives> derivatives)
      : knots_(std::move(knots)), positions_(std::move(positions)), derivatives_(std::move(derivatives)) {}

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Vector3<T> point(const T& t, std::size_t segment) const noexcept {
    const KnotSpan span = knots_.span(segment);
    const auto basis = bernstein_basis<Degree>(span.normalised(t));
    const auto local = [h = span.step()](Derivatives d) {
      double power = 1.0;
      for (Eigen::Vector3d& v : d) v *= power *= h;
      return d;
    };
    const auto left = bernstein_from_taylor(positions_[segment], local(derivatives_[segment]));
    const auto right = bernstein_from_taylor(positions_[segment + 1], inwards(local(derivatives_[segment + 1])));
    Vector3<T> sum = Vector3<T>::Constant(T(0.0));
    for (std::size_t i = 0; i <= orders; ++i)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        sum[axis] += basis[i] * Plain<T>(left[i][axis]) + basis[Degree - i] * Plain<T>(right[i][axis]);
    return sum;
  }

 private:
  Knots knots_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Derivatives> derivatives_;
};

}}  // namespace orispline
