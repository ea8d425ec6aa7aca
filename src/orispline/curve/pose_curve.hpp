// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/curve/curve.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Any curve through points of one kind.
template <CurvePoint P>
using AnyCurveThrough = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, AnyCurve, AnyPath>;

/// A moving body: its orientation curve and, when the keys carry positions, the path of the same kind.
struct PoseCurve {
  AnyCurve orientation;
  std::optional<AnyPath> position{};
};

}}  // namespace orispline
