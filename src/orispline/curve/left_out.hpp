// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/window.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far keys of a window lie from what the six others foretell, as sums of squares: by the polynomial through these
/// and by their natural cubic spline, which beyond its ends is a line.
struct LeftOutErrors {
  double polynomial, natural_spline;
};

/// Of the keys from number `first` to before `past` of a full window, seven keys.
[[nodiscard]] LeftOutErrors left_out_errors(const Window& window, std::size_t first, std::size_t past) noexcept;

}}  // namespace orispline
