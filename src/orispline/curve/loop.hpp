// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/control_points.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/geodesic.hpp>

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

/// A point of a loop, one period away.
template <Number T>
[[nodiscard]] Quaternion<T> come_round(const Quaternion<T>& q, const Closure& closure) {
  return closure.sign < 0.0 ? Quaternion<T>(-q.coeffs()) : q;
}
template <Number T>
[[nodiscard]] Vector3<T> come_round(const Vector3<T>& p, const Closure&) {
  return p;
}

/// The distinct points of a loop with the last one before them and the first two behind them.
template <CurvePoint P>
[[nodiscard]] std::vector<P> points_around(std::span<const P> points, const Closure& closure) {
  std::vector<P> around{come_round(points.back(), closure)};
  around.insert(around.end(), points.begin(), points.end());
  around.insert(around.end(), {come_round(points[0], closure), come_round(points[1], closure)});
  return around;
}

/// The values that those points have.
[[nodiscard]] inline std::vector<double> values_around(const PerKey& values, std::size_t keys) {
  std::vector<double> around;
  for (std::size_t i = 0; i < keys + 3; ++i) around.push_back(values[(i + keys - 1) % keys]);
  return around;
}

/// The four-key polygon of a loop: n distinct keys give n segments, the keys beyond the seam are those of the other
/// side.
template <CurvePoint P>
[[nodiscard]] ORISPLINE_EXPORT ControlPolygon<P> closed_polygon(const Keyframes& keys, const Closure& closure);

}}  // namespace orispline
