// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include <orispline/families/key_findings.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

using PerModel = Eigen::Array<double, static_cast<int>(model_count), 1>;

/// The keys whose times a window has.
inline constexpr std::size_t window_keys = 9;

/// Nine keys seen from one of them.
struct WindowTimes {
  std::array<double, window_keys> x;  ///< times since key `centre`, in median intervals, increasing
  std::size_t centre;
};

/// What every model makes of the increments from the centre of a window to its keys: linear maps, which depend on the
/// times alone. Source: docs/families/measured.md, Formula (1).
struct ModelMaps {
  std::array<PerModel, window_keys> miss;           ///< of the centre by its prediction from the other eight keys
  std::array<PerModel, window_keys> first, second;  ///< derivatives at the centre, by median intervals
  PerModel precision;                               ///< one over the variance of the miss
};
[[nodiscard]] ModelMaps model_maps(const WindowTimes& window);

/// How far a new record at the centre is expected from the curve through the other eight keys: the variance by each
/// model. The curve joins the noise of the keys at both sides of the centre linearly.
[[nodiscard]] PerModel model_variances(const WindowTimes& window);

}}}  // namespace orispline::families
