// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/channel_reduction.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/clip/finite_keys.hpp>
#include <orispline/clip/single_precision.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/highest.hpp>
#include <orispline/reduce/cubic_keys.hpp>
#include <orispline/reduce/hermite_keys.hpp>
#include <orispline/reduce/reduce.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int attempts = 4;  // to hold the tolerance with the numbers of the file too
/// Of the tolerance, for the keys of a method that is then written as cubics; the rest is for these.
constexpr double share_of_keys = 0.8;
constexpr double no_bound = 1e3;  // wider than any angle [rad]: of rotations that are the same throughout

double distance(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return angular_distance(a, b); }
double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm(); }

double distance_from_zero(const Eigen::Quaterniond& tangent) { return tangent.coeffs().norm(); }
double distance_from_zero(const Eigen::Vector3d& tangent) { return tangent.norm(); }

/// The channel as a reader finds it in a file of that precision; nothing where no such file can hold it.
template <CurvePoint P>
std::optional<Channel<P>> stored(Channel<P> channel, KeyPrecision precision) {
  if (precision == KeyPrecision::float32) return held_in_single_precision(std::move(channel));
  return is_finite(channel) ? std::optional(std::move(channel)) : std::nullopt;
}

Expected<Keyframes> keyframes(const RotationChannel& channel) {
  return Keyframes::make({.times = channel.times, .orientations = channel.values});
}
Expected<Keyframes> keyframes(const VectorChannel& channel) {
  KeyframeData data{.times = channel.times, .positions = channel.values};
  data.orientations.assign(channel.size(), Eigen::Quaterniond::Identity());
  return Keyframes::make(std::move(data));
}

RotationChannel followed(const PoseCurve& curve, double tolerance, const RotationChannel&) {
  return cubic_channel(curve.orientation, tolerance).channel;
}
VectorChannel followed(const PoseCurve& curve, double tolerance, const VectorChannel&) {
  return cubic_channel(*curve.position, tolerance).channel;
}

/// With a key of the channel before in the middle of steps of nearly 180°, which readers turn by either way.
RotationChannel without_half_turns(RotationChannel channel, const RotationChannel& before) {
  for (std::size_t k = 0; k + 1 < channel.size();) {
    const auto from = std::ranges::lower_bound(before.times, channel.times[k]),
               to = std::ranges::lower_bound(before.times, channel.times[k + 1]);
    if (to - from < 2 || std::abs(channel.values[k].dot(channel.values[k + 1])) > cosine_near_half_turn) {
      ++k;
      continue;
    }
    const auto middle = static_cast<std::ptrdiff_t>(from - before.times.begin()) + (to - from) / 2;
    const auto place = static_cast<std::ptrdiff_t>(k) + 1;
    channel.times.insert(channel.times.begin() + place, before.times[static_cast<std::size_t>(middle)]);
    channel.values.insert(channel.values.begin() + place, before.values[static_cast<std::size_t>(middle)]);
  }
  return channel;
}
VectorChannel without_half_turns(VectorChannel channel, const VectorChannel&) { return channel; }

/// By a method of the registry: `slerp` as geodesics, others as cubics that follow their curve.
template <CurvePoint P>
Expected<Channel<P>> by_method(const Channel<P>& channel, double tolerance, const Method& method) {
  const bool is_linear = method.name == "slerp", is_angle = std::same_as<P, Eigen::Quaterniond>;
  const double of_keys = is_linear ? tolerance : share_of_keys * tolerance;
  const ReduceOptions options{.tolerance =
                                  is_angle ? Tolerance{of_keys} : Tolerance{.angle = no_bound, .position = of_keys}};
  const auto keys = keyframes(channel);
  if (!keys) return tl::unexpected(keys.error());
  auto reduction = reduce(Track(*keys), method, options);
  if (!reduction) return tl::unexpected(std::move(reduction.error()));
  const Keyframes& found = reduction->track.keys;
  if (!is_linear)
    return make_pose_curve(reduction->method, found).map([&](const PoseCurve& curve) {
      return followed(curve, (1.0 - share_of_keys) * tolerance, channel);
    });
  Channel<P> result{.interpolation = ChannelInterpolation::linear};
  result.times.assign(found.times().begin(), found.times().end());
  const auto points = found.points<P>();
  result.values.assign(points.begin(), points.end());
  return without_half_turns(std::move(result), channel);
}

/// How far apart two values may be that are the same but for rounding of files [rad, or a length].
template <CurvePoint P>
constexpr double rounding = std::same_as<P, Eigen::Quaterniond> ? rest_angle : rest_length;

/// Whether a spline may swing farther than that between keys that are the same.
template <CurvePoint P>
bool swings(const Channel<P>& channel, double farthest) {
  if (channel.interpolation != ChannelInterpolation::cubicspline) return false;
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    const double interval = channel.times[i + 1] - channel.times[i];
    for (const P& tangent : {channel.out_tangents[i], channel.in_tangents[i + 1]})
      if (distance_from_zero(tangent) * interval > farthest) return true;
  }
  return false;
}

}  // namespace

template <CurvePoint P>
Channel<P> resting_channel(const Channel<P>& channel, const P& rest, double farthest, KeyPrecision precision) {
  if (swings(channel, farthest)) return channel;
  const bool is_step = channel.interpolation == ChannelInterpolation::step;
  for (const P& held : {rest, channel.values.front()}) {
    Channel<P> resting{.joint = channel.joint,
                       .interpolation = is_step ? ChannelInterpolation::step : ChannelInterpolation::linear,
                       .times = {channel.times.front()},
                       .values = {held}};
    const auto in_file = stored(resting, precision);
    if (!in_file) continue;
    const P& read = in_file->values.front();
    if (std::ranges::all_of(channel.values, [&](const P& value) { return distance(read, value) <= farthest; }))
      return resting;
  }
  return channel;
}

template <CurvePoint P>
LargestInTime farthest_at_keys(const Channel<P>& before, const Channel<P>& after) {
  const ChannelCurve<P> curve(after);
  LargestInTime farthest{.time = before.times.front()};
  for (std::size_t i = 0; i < before.size(); ++i)
    farthest.take(distance(before.values[i], curve.at(before.times[i])), before.times[i]);
  return farthest;
}

template <CurvePoint P>
LargestInTime farthest_between(const Channel<P>& before, const Channel<P>& after, BetweenSamples between) {
  const CubicSamples<P> samples = cubic_samples(before, between);
  const ChannelCurve<P> curve(after);
  const auto off = [&](double t) { return distance(samples.motion(t), curve.at(t)); };
  const std::vector<double>& times = samples.targets.times;
  std::vector<double> distances;
  for (std::size_t i = 0; i < times.size(); ++i)
    distances.push_back(distance(P(samples.targets.points[i]), curve.at(times[i])));
  const Height farthest = highest(times, distances, off);
  return {.value = farthest.value, .time = farthest.place};
}

template <CurvePoint P>
bool ends_as_it_begins(const Channel<P>& channel) {
  return distance(channel.values.front(), channel.values.back()) <= rounding<P>;
}

template <CurvePoint P>
Expected<Channel<P>> reduced_channel(const Channel<P>& channel, double tolerance, const ClipReduceOptions& options) {
  if (channel.size() < 3 || channel.interpolation == ChannelInterpolation::step) return channel;
  const bool is_cubic = options.method.name == cubicspline_method, is_fitted = is_cubic || seeks_rates(options.method);
  const bool closes = options.closed && ends_as_it_begins(channel);
  const std::optional<CubicSamples<P>> samples =
      is_fitted ? std::optional(cubic_samples(channel, options.between)) : std::nullopt;
  const auto reduced_within = [&](double asked) -> Expected<Channel<P>> {
    if (is_cubic) return fewest_cubics(*samples, asked, closes);
    return is_fitted ? hermite_channel(*samples, asked, options.method, closes)
                     : by_method(channel, asked, options.method);
  };
  double asked = tolerance;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Expected<Channel<P>> fewer = reduced_within(asked);
    if (!fewer) return fewer;
    std::optional<Channel<P>> reduced = stored(*std::move(fewer), options.precision);
    if (!reduced || reduced->size() >= channel.size()) break;
    reduced->joint = channel.joint;
    const double found = farthest_at_keys(channel, *reduced).value;
    if (found <= tolerance) return *std::move(reduced);
    asked *= 0.999 * tolerance / found;
  }
  return channel;
}

template RotationChannel resting_channel(const RotationChannel&, const Eigen::Quaterniond&, double, KeyPrecision);
template VectorChannel resting_channel(const VectorChannel&, const Eigen::Vector3d&, double, KeyPrecision);
template LargestInTime farthest_at_keys(const RotationChannel&, const RotationChannel&);
template LargestInTime farthest_at_keys(const VectorChannel&, const VectorChannel&);
template LargestInTime farthest_between(const RotationChannel&, const RotationChannel&, BetweenSamples);
template LargestInTime farthest_between(const VectorChannel&, const VectorChannel&, BetweenSamples);
template bool ends_as_it_begins(const RotationChannel&);
template bool ends_as_it_begins(const VectorChannel&);
template Expected<RotationChannel> reduced_channel(const RotationChannel&, double, const ClipReduceOptions&);
template Expected<VectorChannel> reduced_channel(const VectorChannel&, double, const ClipReduceOptions&);

}}  // namespace orispline
