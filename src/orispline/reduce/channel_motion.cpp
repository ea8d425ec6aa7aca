// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/channel_motion.hpp>

#include <optional>
#include <variant>

#include <orispline/curve/taylor.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Method smooth_method() { return {"auto", {.parameters = {{"hold", {1.0}}}}}; }

std::optional<AnyCurve> smooth_curve(const RotationChannel& channel) {
  auto curve =
      Keyframes::make({.times = channel.times, .orientations = channel.values}).and_then([](const Keyframes& keys) {
        return make_curve(smooth_method(), keys);
      });
  return curve ? std::optional(*std::move(curve)) : std::nullopt;
}
std::optional<AnyPath> smooth_curve(const VectorChannel& channel) {
  KeyframeData data{.times = channel.times, .positions = channel.values};
  data.orientations.assign(channel.size(), Eigen::Quaterniond::Identity());
  auto curve = Keyframes::make(std::move(data)).and_then([](const Keyframes& keys) {
    return make_pose_curve(smooth_method(), keys);
  });
  return curve ? std::optional(*std::move(curve->position)) : std::nullopt;
}

Eigen::Quaterniond point_of(const AnyCurve& curve, double t) { return curve(t); }
Eigen::Vector3d point_of(const AnyPath& path, double t) { return path.linear_motion(t).position; }
Motion motion_of(const AnyCurve& curve, double t) { return curve.motion(t); }
LinearMotion motion_of(const AnyPath& path, double t) { return path.linear_motion(t); }
template <CurvePoint P>
P point_of(const ChannelCurve<P>& curve, double t) {
  return curve.at(t);
}
template <CurvePoint P>
MotionOf<P> motion_of(const ChannelCurve<P>& curve, double t) {
  return curve.motion(t);
}

/// One curve after the other.
template <CurvePoint P>
class Stretches {
 public:
  Stretches(const Channel<P>& channel, std::span<const Cut> cuts) : knots_(channel.times) {
    pass_stretches(channel, cuts, [&](std::size_t first, std::size_t last) {
      const Channel<P> stretch = stretch_of(channel, first, last);
      auto smooth = last > first + 1 ? smooth_curve(stretch) : std::nullopt;
      if (smooth) curves_.emplace_back(*std::move(smooth));
      else curves_.emplace_back(ChannelCurve<P>(stretch));
      curve_of_.resize(last, curves_.size() - 1);
    });
  }
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] P point(double t, std::size_t segment) const noexcept {
    return std::visit([t](const auto& curve) { return point_of(curve, t); }, curves_[curve_of_[segment]]);
  }
  [[nodiscard]] MotionOf<P> motion(double t, std::size_t segment) const noexcept {
    return std::visit([t](const auto& curve) { return motion_of(curve, t); }, curves_[curve_of_[segment]]);
  }
  [[nodiscard]] PointOver<P, Jet<double, 3>> point(const Jet<double, 3>& t, std::size_t segment) const noexcept {
    return taylor(motion(t.c[0], segment), t - t.c[0]);
  }

 private:
  Knots knots_;
  std::vector<std::variant<AnyCurveThrough<P>, ChannelCurve<P>>> curves_;
  std::vector<std::size_t> curve_of_;  ///< of every segment
};

}  // namespace

template <CurvePoint P>
ChannelCurve<P> motion_between(const Channel<P>& channel, BetweenSamples between, std::span<const Cut> cuts) {
  if (between == BetweenSamples::stored || channel.interpolation != ChannelInterpolation::linear || channel.size() < 3)
    return ChannelCurve<P>(channel);
  return {channel.joint, ErasedCurve<P>(Stretches<P>(channel, cuts))};
}

template ChannelCurve<Eigen::Quaterniond> motion_between(const RotationChannel&, BetweenSamples, std::span<const Cut>);
template ChannelCurve<Eigen::Vector3d> motion_between(const VectorChannel&, BetweenSamples, std::span<const Cut>);

}}  // namespace orispline
