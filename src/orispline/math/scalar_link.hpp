// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The link of two nodes of the scalar smoother: its value and P-1 derivatives at both ends, whose combination has the
/// squared norm ∫|f^(P)|² dt.
template <int P>
Eigen::Matrix<double, P, 2 * P> scalar_link(double h) {
  Eigen::Matrix<double, P, 2 * P> link;
  const double sqrt3 = std::sqrt(3.0), sqrt5 = std::sqrt(5.0), root = std::sqrt(h);
  if constexpr (P == 2) {
    link << 0.0, -h, 0.0, h,  //
        2.0 * sqrt3, sqrt3 * h, -2.0 * sqrt3, sqrt3 * h;
    return link / (h * root);
  } else {
    const double q = h * h;
    link << 0.0, 0.0, -q, 0.0, 0.0, q,                                      //
        0.0, 2.0 * sqrt3 * h, sqrt3 * q, 0.0, -2.0 * sqrt3 * h, sqrt3 * q,  //
        -12.0 * sqrt5, -6.0 * sqrt5 * h, -sqrt5 * q, 12.0 * sqrt5, -6.0 * sqrt5 * h, sqrt5 * q;
    return link / (q * root);
  }
}

}}  // namespace orispline
