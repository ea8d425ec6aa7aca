// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/rest.hpp>

#include <algorithm>
#include <vector>

#include <orispline/math/shorter_way.hpp>
#include <orispline/reduce/stored_channel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double distance_from_zero(const Eigen::Quaterniond& tangent) { return tangent.coeffs().norm(); }
double distance_from_zero(const Eigen::Vector3d& tangent) { return tangent.norm(); }

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

bool are_same(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.coeffs() == b.coeffs(); }
bool are_same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a == b; }

template <CurvePoint P>
using PartOfPose = P JointPose::*;

/// Takes out what rests in one list of a clip; returns how many went.
template <CurvePoint P>
std::size_t take_out(const Skeleton& skeleton, std::vector<Channel<P>>& channels, PartOfPose<P> part) {
  return std::erase_if(channels,
                       [&](const Channel<P>& channel) { return is_rest(channel, skeleton[channel.joint].rest.*part); });
}

/// The first of the channels before that has a key at that time goes back to its place; returns how many did.
template <CurvePoint P>
std::size_t put_back(const std::vector<Channel<P>>& before, std::vector<Channel<P>>& after, double time) {
  const auto found = std::ranges::find_if(
      before, [&](const Channel<P>& channel) { return channel.size() == 1 && channel.times.front() == time; });
  if (found == before.end()) return 0;
  const auto place = std::ranges::find_if(after, [&](const Channel<P>& channel) {
    return std::ranges::find(found, before.end(), channel.joint, &Channel<P>::joint) != before.end();
  });
  after.insert(place, *found);
  return 1;
}

}  // namespace

template <CurvePoint P>
bool is_rest(const Channel<P>& channel, const P& rest) {
  return channel.size() == 1 && are_same(channel.values.front(), rest);
}

template <CurvePoint P>
Channel<P> resting_channel(const Channel<P>& channel, const P& rest, double farthest, KeyPrecision precision) {
  if (swings(channel, farthest)) return channel;
  const bool is_step = channel.interpolation == ChannelInterpolation::step;
  const auto is_near = [&](const P& held) {
    return std::ranges::all_of(channel.values,
                               [&](const P& value) { return distance_between(held, value) <= farthest; });
  };
  for (const P& held : {rest, channel.values.front()}) {
    Channel<P> resting{.joint = channel.joint,
                       .interpolation = is_step ? ChannelInterpolation::step : ChannelInterpolation::linear,
                       .times = {channel.times.front()},
                       .values = {held}};
    const auto in_file = stored(resting, precision);
    // The rest pose is also what the joint has without the channel, whatever the precision of that.
    if (in_file && is_near(in_file->values.front()) && is_near(held)) return resting;
  }
  return channel;
}

RidOfRest take_out_resting(const Skeleton& skeleton, Clip& clip) {
  const Clip before = clip;
  RidOfRest gone{.rotations = take_out(skeleton, clip.rotations, &JointPose::rotation),
                 .translations = take_out(skeleton, clip.translations, &JointPose::translation),
                 .scales = take_out(skeleton, clip.scales, &JointPose::scale)};
  const auto keep_key_at = [&](double time) {
    if (const std::size_t rotations = put_back(before.rotations, clip.rotations, time)) gone.rotations -= rotations;
    else if (const std::size_t some = put_back(before.translations, clip.translations, time)) gone.translations -= some;
    else gone.scales -= put_back(before.scales, clip.scales, time);
  };
  const bool is_empty = clip.rotations.empty() && clip.translations.empty() && clip.scales.empty();
  if (gone.all() == 0) return gone;
  if (is_empty || clip.domain().start != before.domain().start) keep_key_at(before.domain().start);
  if (clip.domain().end != before.domain().end) keep_key_at(before.domain().end);
  return gone;
}

template bool is_rest(const RotationChannel&, const Eigen::Quaterniond&);
template bool is_rest(const VectorChannel&, const Eigen::Vector3d&);
template RotationChannel resting_channel(const RotationChannel&, const Eigen::Quaterniond&, double, KeyPrecision);
template VectorChannel resting_channel(const VectorChannel&, const Eigen::Vector3d&, double, KeyPrecision);

}}  // namespace orispline
