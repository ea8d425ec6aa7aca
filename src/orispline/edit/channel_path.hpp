// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <orispline/clip/clip.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/taylor.hpp>
#include <orispline/math/shorter_way.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The curve of a channel as any other one: its points over jets are those of its motion.
template <CurvePoint P>
struct StoredCurve {
  ErasedCurve<P> curve;

  [[nodiscard]] const Knots& knots() const noexcept { return curve.knots(); }
  [[nodiscard]] P point(double t, std::size_t segment) const noexcept { return curve.point(t, segment); }
  [[nodiscard]] PointOver<P, Jet<double, 3>> point(const Jet<double, 3>& t, std::size_t segment) const noexcept {
    return taylor(curve.motion(t.c[0], segment), t - t.c[0]);
  }
  [[nodiscard]] MotionOf<P> motion(double t, std::size_t segment) const noexcept { return curve.motion(t, segment); }
};

/// The motion that a channel means: of `linear` ones, whose keys are samples, the C2 curve `auto` through them; of all
/// others what lies between their keys. Errors: those of the keys.
template <CurvePoint P>
[[nodiscard]] Expected<AnyCurveThrough<P>> meant_curve(const Channel<P>& channel);
extern template Expected<AnyCurve> meant_curve(const RotationChannel&);
extern template Expected<AnyPath> meant_curve(const VectorChannel&);

/// Of either kind of curve.
[[nodiscard]] inline Motion motion_at(const AnyCurve& curve, double t, Side side = Side::right) noexcept {
  return curve.motion(t, side);
}
[[nodiscard]] inline LinearMotion motion_at(const AnyPath& path, double t, Side side = Side::right) noexcept {
  return path.linear_motion(t, side);
}
[[nodiscard]] inline Motion motion_on(const AnyCurve& curve, std::size_t segment, double t) noexcept {
  return curve.motion_on(segment, t);
}
[[nodiscard]] inline LinearMotion motion_on(const AnyPath& path, std::size_t segment, double t) noexcept {
  return path.linear_motion_on(segment, t);
}
[[nodiscard]] inline Eigen::Quaterniond point_of(const Motion& motion) noexcept { return motion.orientation; }
[[nodiscard]] inline Eigen::Vector3d point_of(const LinearMotion& motion) noexcept { return motion.position; }

/// Whether a channel has the same value at all keys.
template <CurvePoint P>
[[nodiscard]] bool rests(const Channel<P>& channel) {
  const auto is_zero = [](const P& tangent) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>) return tangent.coeffs().isZero(0.0);
    else return tangent.isZero(0.0);
  };
  return std::ranges::all_of(channel.values,
                             [&](const P& v) { return distance_between(v, channel.values.front()) == 0.0; }) &&
         std::ranges::all_of(channel.in_tangents, is_zero) && std::ranges::all_of(channel.out_tangents, is_zero);
}

}}  // namespace orispline
