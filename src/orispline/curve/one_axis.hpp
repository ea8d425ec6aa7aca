// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <span>

#include <orispline/math/geodesic.hpp>

// Turns about one axis add up like angles, as far as they wind. A logarithm tells no more than one turn either way: a
// curve that takes one between two moving points would jump where they come a full turn apart. Where they turn about
// different axes they pass that place at a distance, and nothing jumps.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Turns lie on one axis from which they point aside by no more than this, per radian where they are longer [rad].
inline constexpr double one_axis_tolerance = 1e-6;

/// A full turn [rad] is where the logarithm wraps: a rotation vector that long is one that turns the other way round.
inline constexpr double full_turn = 2.0 * std::numbers::pi;

/// Whether rotation vectors [rad] have one axis.
[[nodiscard]] bool have_one_axis(std::span<const Eigen::Vector3d> turns) noexcept;

/// Whether the logarithm wraps on the way from none to so wide a turn [rad].
[[nodiscard]] inline bool wraps(const Eigen::Vector3d& turn) noexcept {
  return turn.norm() > full_turn - 2.0 * one_axis_tolerance;
}

/// The increment from one orientation to another, as far round as an estimate of it about the same axis says.
[[nodiscard]] Eigen::Vector3d increment_near(const Eigen::Vector3d& estimate, const Eigen::Quaterniond& from,
                                             const Eigen::Quaterniond& to) noexcept;

/// Between two rotation vectors of one axis; exactly the one or the other where `share` is 0 or 1.
template <Number T>
[[nodiscard]] Vector3<T> mixed(const Vector3<T>& from, const Vector3<T>& to, const T& share) noexcept {
  return from * T(T(1.0) - share) + to * share;
}

/// The point at a displacement `way` from `from`, on the way to `to`, which is at `step`, all about one axis.
///
/// From `to` it is the same, at `way` less `step`; `share` passes from 0 at the one to 1 at the other, so that what
/// points aside within the tolerance moves neither.
template <Number T, CurvePoint P>
[[nodiscard]] PointOver<P, T> displaced_about_one_axis(const P& from, const P& to, const Displacement<P>& step,
                                                       const Vector3<T>& way, const T& share) noexcept {
  return on_geodesic<T>(displaced<T>(constant<T>(from), way),
                        displaced<T>(constant<T>(to), Vector3<T>(way - constant<T>(step))), share);
}

}}  // namespace orispline
