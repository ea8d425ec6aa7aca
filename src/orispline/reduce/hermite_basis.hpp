// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The cubic Hermite basis at a local time u in [0, 1]: what the ends count for, and the derivatives there times the
/// length of the piece.
struct HermiteBasis {
  double start, leaving, arriving, end;
};

[[nodiscard]] constexpr HermiteBasis hermite_basis(double u) noexcept {
  const double v = 1.0 - u;
  return {
      .start = v * v * (1.0 + 2.0 * u), .leaving = u * v * v, .arriving = -u * u * v, .end = u * u * (1.0 + 2.0 * v)};
}

}}  // namespace orispline
