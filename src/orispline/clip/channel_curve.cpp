// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/channel_curve.hpp>

#include <utility>

#include <orispline/clip/channel_pieces.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

template <CurvePoint P>
ErasedCurve<P> curve_of(const Channel<P>& channel) {
  return std::visit([](auto pieces) { return ErasedCurve<P>(std::move(pieces)); }, pieces_of(channel));
}

Motion at_rest(const Eigen::Quaterniond& value) { return {.orientation = value}; }
LinearMotion at_rest(const Eigen::Vector3d& value) { return {.position = value}; }

}  // namespace

template <CurvePoint P>
ChannelCurve<P>::ChannelCurve(const Channel<P>& channel)
    : curve_(curve_of(channel)), last_(channel.values.back()), joint_(channel.joint) {}

template <CurvePoint P>
P ChannelCurve<P>::at(double t) const noexcept {
  if (t >= knots().back()) return last_;
  t = std::max(t, knots().front());
  return curve_.point(t, knots().segment_at(t));
}

template <CurvePoint P>
MotionOf<P> ChannelCurve<P>::motion(double t) const noexcept {
  if (t < knots().front() || t > knots().back()) return at_rest(at(t));
  MotionOf<P> motion = curve_.motion(t, knots().segment_at(t));
  if (t == knots().back()) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>) motion.orientation = last_;
    else motion.position = last_;
  }
  return motion;
}

template class ChannelCurve<Eigen::Quaterniond>;
template class ChannelCurve<Eigen::Vector3d>;

}}  // namespace orispline
