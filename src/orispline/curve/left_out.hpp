// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/window.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// How far the inner keys of a window lie from what the six others foretell, as sums of squares: by the polynomial
/// through these and by their natural cubic spline.
struct LeftOutErrors {
  double polynomial, natural_spline;
};

/// Of a full window, seven keys.
[[nodiscard]] LeftOutErrors left_out_errors(const Window& window) noexcept;

}  // namespace orispline::inline ORISPLINE_ABI
