// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/extrapolation.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Motion kept(const Motion& end, double seconds) noexcept {
  return {.orientation = displaced(end.orientation, Eigen::Vector3d(seconds * end.angular_velocity)),
          .angular_velocity = end.angular_velocity};
}

LinearMotion kept(const LinearMotion& end, double seconds) noexcept {
  return {.position = end.position + seconds * end.velocity, .velocity = end.velocity};
}

Motion motion_at(const AnyCurve& curve, double t) noexcept { return curve.motion(t); }
LinearMotion motion_at(const AnyPath& path, double t) noexcept { return path.linear_motion(t); }

Motion motion_on(const AnyCurve& curve, std::size_t segment, double t) noexcept { return curve.motion_on(segment, t); }
LinearMotion motion_on(const AnyPath& path, std::size_t segment, double t) noexcept {
  return path.linear_motion_on(segment, t);
}

/// `P`: what the curve goes through.
template <CurvePoint P>
MotionOf<P> extrapolated_through(const AnyCurveThrough<P>& curve, double t, Extrapolation how) noexcept {
  const Knots& knots = curve.knots();
  const bool is_outside = t < knots.front() || t > knots.back();
  if (!is_outside || how == Extrapolation::hold) return motion_at(curve, t);
  const double end = t < knots.front() ? knots.front() : knots.back();
  if (how == Extrapolation::rate) return kept(motion_at(curve, end), t - end);
  if (how == Extrapolation::segment) return motion_on(curve, knots.segment_at(t), t);
  return no_motion<P>();
}

}  // namespace

Motion extrapolated(const AnyCurve& curve, double t, Extrapolation how) noexcept {
  return extrapolated_through<Eigen::Quaterniond>(curve, t, how);
}

LinearMotion extrapolated(const AnyPath& path, double t, Extrapolation how) noexcept {
  return extrapolated_through<Eigen::Vector3d>(path, t, how);
}

}}  // namespace orispline
