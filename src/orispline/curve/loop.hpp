// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/control_points.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A key this near to the first one [rad], [m] is the first one come back.
inline constexpr double closing_tolerance = 1e-6;

/// The distinct keys of a loop and how it closes.
struct ClosedKeys {
  Keyframes keys;
  Closure closure;
};

/// Finds the closing key or uses the given period.
///
/// The loop's sign on S³ is that of the closing key where there is one, else the one that makes the last step the
/// shorter. Errors: bad_data when no period is given and the last key is not the first one again; bad_argument for a
/// period that does not reach beyond the last key.
[[nodiscard]] ORISPLINE_EXPORT Expected<ClosedKeys> closed_keys(const Keyframes& keys, const Loop& loop);

/// Key times with the return to the first key: n keys give n+1 knots whose steps wrap around.
[[nodiscard]] ORISPLINE_EXPORT Knots closed_knots(const Keyframes& keys, const Closure& closure);

/// The orientations at the knots of an open or closed curve: a loop comes back to the first key with its sign.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Eigen::Quaterniond> joint_orientations(const Keyframes& keys,
                                                                                  const FamilySettings& settings);

/// The four-key polygon of a loop: n distinct keys give n segments, the keys beyond the seam are those of the other
/// side.
template <CurvePoint P>
[[nodiscard]] ORISPLINE_EXPORT ControlPolygon<P> closed_polygon(const Keyframes& keys, const Closure& closure);

}}  // namespace orispline
