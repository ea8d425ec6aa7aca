// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/cubic_samples.hpp>

#include <functional>
#include <optional>

#include <orispline/clip/channel_curve.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t stride = 4;  // three points between two samples

template <CurvePoint P>
using PointAt = std::function<P(double)>;

/// That stands still between keys that are equal, as joints do that rest.
Method between_method() { return {"auto", {.parameters = {{"hold", {1.0}}}}}; }

/// Keys that `auto` refuses, such as two nearly at one time, have no smooth motion.
std::optional<PointAt<Eigen::Quaterniond>> smooth_motion(const RotationChannel& channel) {
  auto curve =
      Keyframes::make({.times = channel.times, .orientations = channel.values}).and_then([](const Keyframes& keys) {
        return make_curve(between_method(), keys);
      });
  if (!curve) return std::nullopt;
  return [curve = *std::move(curve)](double t) { return curve(t); };
}
std::optional<PointAt<Eigen::Vector3d>> smooth_motion(const VectorChannel& channel) {
  KeyframeData data{.times = channel.times, .positions = channel.values};
  data.orientations.assign(channel.size(), Eigen::Quaterniond::Identity());
  auto curve = Keyframes::make(std::move(data)).and_then([](const Keyframes& keys) {
    return make_pose_curve(between_method(), keys);
  });
  if (!curve) return std::nullopt;
  return [path = *std::move(curve->position)](double t) { return path.linear_motion(t).position; };
}

template <CurvePoint P>
PointAt<P> motion_between(const Channel<P>& channel, BetweenSamples between) {
  if (between == BetweenSamples::smooth && channel.interpolation == ChannelInterpolation::linear)
    if (auto motion = smooth_motion(channel)) return *std::move(motion);
  return [curve = ChannelCurve<P>(channel)](double t) { return curve.at(t); };
}

Eigen::Vector4d components(const Eigen::Quaterniond& point) { return point.coeffs(); }
Eigen::Vector3d components(const Eigen::Vector3d& point) { return point; }

/// With the sign of the nearer of the two quaternions that are that orientation.
void append(std::vector<Eigen::Vector4d>& points, Eigen::Vector4d point) {
  if (!points.empty() && points.back().dot(point) < 0.0) point = -point;
  points.push_back(point);
}
void append(std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& point) { points.push_back(point); }

}  // namespace

template <CurvePoint P>
CubicSamples<P> cubic_samples(const Channel<P>& channel, BetweenSamples between) {
  const PointAt<P> motion = motion_between(channel, between);
  CubicSamples<P> samples{.stride = stride};
  auto& [times, points] = samples.targets;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    times.push_back(channel.times[i]);
    append(points, components(channel.values[i]));
    if (i + 1 == channel.size()) break;
    for (std::size_t k = 1; k < stride; ++k) {
      const double share = static_cast<double>(k) / stride;
      times.push_back(channel.times[i] + share * (channel.times[i + 1] - channel.times[i]));
      append(points, components(motion(times.back())));
    }
  }
  return samples;
}

template CubicSamples<Eigen::Quaterniond> cubic_samples(const Channel<Eigen::Quaterniond>&, BetweenSamples);
template CubicSamples<Eigen::Vector3d> cubic_samples(const Channel<Eigen::Vector3d>&, BetweenSamples);

}}  // namespace orispline
