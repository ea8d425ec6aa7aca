// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/join.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/edit/blended_curve.hpp>
#include <orispline/edit/cut.hpp>
#include <orispline/edit/linear_keys.hpp>
#include <orispline/edit/travel.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/rotation_matrix.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double same_rotation = 1e-3;  // of rest poses [rad]
constexpr double same_length = 1e-3;    // of their translations and scales, as a share of them
constexpr double joined_within = 1e-5;  // of cubics from the curve that is blended [rad, or the unit of lengths]
constexpr double same_frame = 1e-2;     // shares of an interval between keys by which two times are one

const Eigen::Quaterniond& rest_of(const Skeleton& skeleton, const RotationChannel& channel) {
  return skeleton[channel.joint].rest.rotation;
}

bool is_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).norm() <= same_length * std::max({a.norm(), b.norm(), 1e-9});
}

bool have_one_pose(const JointPose& a, const JointPose& b) {
  return angular_distance(a.rotation, b.rotation) <= same_rotation && is_near(a.translation, b.translation) &&
         is_near(a.scale, b.scale);
}

/// The joints that move in a clip, with all above them.
std::vector<bool> moved_in(const Skeleton& skeleton, const Clip& clip) {
  std::vector<bool> moved(skeleton.size());
  const auto add = [&](const auto& channels) {
    for (const auto& channel : channels)
      for (std::size_t joint = channel.joint; joint != no_parent; joint = skeleton[joint].parent) moved[joint] = true;
  };
  add(clip.rotations);
  add(clip.translations);
  add(clip.scales);
  return moved;
}

tl::unexpected<Error> unlike(const Skeleton& skeleton, std::size_t joint, std::string_view found) {
  return failure(ErrorCode::bad_data, formatted("joint {}: found {}, wanted the same skeleton in both files",
                                                in_quotes(skeleton.shown_name(joint)), found));
}

/// A channel that rests where another clip moves.
RotationChannel resting(const Skeleton& skeleton, const RotationChannel& other, double time) {
  return {.joint = other.joint,
          .interpolation = other.interpolation,
          .times = std::vector<double>(1, time),
          .values = std::vector<Eigen::Quaterniond>(1, rest_of(skeleton, other))};
}

/// Two channels of one joint, the second on the clock of the first.
template <CurvePoint P>
class ChannelJoin {
 public:
  ChannelJoin(Channel<P> first, Channel<P> second, Domain start_to_end, Domain blend)
      : first_(std::move(first)), second_(std::move(second)), whole_(start_to_end), blend_(blend) {}

  [[nodiscard]] Expected<Channel<P>> made() {
    if (first_.size() == 1 && second_.size() == 1 && distance_between(first_.values[0], second_.values[0]) == 0.0)
      return first_;
    if (is_linear(first_) && is_linear(second_)) return of_samples();
    if (is_step(first_) && is_step(second_)) return of_steps();
    return of_cubics();
  }

 private:
  static bool is_step(const Channel<P>& channel) {
    return channel.interpolation == ChannelInterpolation::step || channel.size() == 1;
  }
  static bool is_linear(const Channel<P>& channel) {
    return channel.interpolation == ChannelInterpolation::linear || channel.size() == 1;
  }

  [[nodiscard]] Channel<P> of_steps() const {
    const double middle = 0.5 * (blend_.start + blend_.end);
    Channel<P> all = spread(first_, whole_.start, middle);
    all.times.pop_back();
    all.values.pop_back();
    all.interpolation = ChannelInterpolation::step;
    append(all, spread(second_, middle, whole_.end), 0);
    return all;
  }

  /// A channel with two keys at least, over a stretch.
  static Channel<P> spread(Channel<P> channel, double from, double to) {
    if (channel.size() == 1) {
      channel.times = std::vector<double>{from, to};
      channel.values.push_back(channel.values.front());
      if (channel.interpolation == ChannelInterpolation::cubicspline)
        channel.interpolation = ChannelInterpolation::linear;
      channel.in_tangents = channel.out_tangents = {};
      return channel;
    }
    return part_of(channel, from, to);
  }

  [[nodiscard]] static bool spans(const Channel<P>& channel, Domain over) {
    return channel.size() > 1 && channel.times.front() <= over.start && channel.times.back() >= over.end;
  }
  /// The motion that it means over the blend.
  [[nodiscard]] Expected<AnyCurveThrough<P>> curve_of(const Channel<P>& channel) const {
    return meant_curve(spans(channel, blend_) ? channel : spread(channel, blend_.start, blend_.end));
  }

  [[nodiscard]] Expected<Channel<P>> of_samples() const {
    return curve_of(first_).and_then([&](const auto& from) {
      return curve_of(second_).map([&](const auto& to) {
        const auto curve = orispline::blended(from, to, blend_);
        Channel<P> all = spread(first_, whole_.start, blend_.start);
        all.interpolation = ChannelInterpolation::linear;
        LinearKeys<P> keys(all, curve);
        for (const double t : inner_times()) keys.go_to(t);
        keys.go_to(blend_.end);
        append(all, spread(second_, blend_.end, whole_.end), 1);
        return all;
      });
    });
  }

  /// Of both channels inside of the blend; of two that are one but for rounding the first one.
  [[nodiscard]] std::vector<double> inner_times() const {
    std::vector<double> times;
    const auto inside = [&](double t) { return t > blend_.start && t < blend_.end; };
    std::ranges::copy_if(first_.times, std::back_inserter(times), inside);
    std::ranges::copy_if(second_.times, std::back_inserter(times), inside);
    std::ranges::sort(times);
    const double least = same_frame * (blend_.end - blend_.start) / static_cast<double>(times.size() + 1);
    std::vector<double> apart;
    for (const double t : times)
      if (t - blend_.start > least && blend_.end - t > least && (apart.empty() || t - apart.back() > least))
        apart.push_back(t);
    return apart;
  }

  [[nodiscard]] Expected<Channel<P>> of_cubics() const {
    const auto stored = [&](const Channel<P>& channel) {
      return AnyCurveThrough<P>(StoredCurve<P>{ChannelCurve<P>(spread(channel, blend_.start, blend_.end)).curve()});
    };
    Channel<P> all = as_cubics(first_, whole_.start, blend_.start);
    append(all, cubic_channel(orispline::blended(stored(first_), stored(second_), blend_), joined_within).channel, 1);
    append(all, as_cubics(second_, blend_.end, whole_.end), 1);
    return all;
  }

  static Channel<P> as_cubics(const Channel<P>& channel, double from, double to) {
    Channel<P> part = spread(channel, from, to);
    if (part.interpolation == ChannelInterpolation::cubicspline) return part;
    const std::size_t joint = part.joint;
    part = cubic_channel(AnyCurveThrough<P>(StoredCurve<P>{ChannelCurve<P>(part).curve()}), joined_within).channel;
    part.joint = joint;
    return part;
  }

  /// Without its first keys, which are there already; the signs go on.
  static void append(Channel<P>& all, Channel<P> more, std::size_t left_out) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      if (all.values.back().dot(more.values.front()) < 0.0)
        for (SharedList<P>* const list : {&more.values, &more.in_tangents, &more.out_tangents})
          for (P& q : *list) q.coeffs() *= -1.0;
    if (left_out > 0 && !more.out_tangents.empty()) all.out_tangents.back() = more.out_tangents.front();
    for (std::size_t i = left_out; i < more.size(); ++i) {
      all.times.push_back(more.times[i]);
      all.values.push_back(more.values[i]);
      if (more.in_tangents.empty()) continue;
      all.in_tangents.push_back(more.in_tangents[i]);
      all.out_tangents.push_back(more.out_tangents[i]);
    }
  }

  Channel<P> first_, second_;
  Domain whole_, blend_;
};

/// Joins all channels of two clips.
class ClipJoin {
 public:
  ClipJoin(const Skeleton& skeleton, const Clip& first, Clip second, const JoinOptions& options)
      : skeleton_(skeleton), first_(first), second_(std::move(second)), options_(options) {}

  Expected<JoinedClip> made() {
    const Domain before = first_.domain(), after = second_.domain();
    const double shortest = std::min(before.end - before.start, after.end - after.start);
    if (!(options_.blend < shortest))
      return bad_option("blend", formatted("found {} s, wanted less than the shorter of both clips, which takes {} s",
                                           options_.blend, shortest));
    joined_.blend = {frame_near(before.end - options_.blend), before.end};
    second_ = shifted(std::move(second_), joined_.blend.start - after.start);
    meet_frame(second_.rotations);
    meet_frame(second_.translations);
    meet_frame(second_.scales);
    for (WeightChannels& weights : second_.weights) meet_frame(weights.triples);
    whole_ = {before.start, second_.domain().end};
    place();
    joined_.clip = {.name = first_.name, .passed_on = first_.passed_on};
    Expected<void> added{};
    const auto each = [&](const auto& ours, const auto& theirs, auto& all, const auto& rest) {
      const auto add = [&](auto one, auto other) {
        using Joined = std::remove_cvref_t<decltype(one)>;
        if (!added) return;
        auto channel = ChannelJoin(Joined(std::move(one)), Joined(std::move(other)), whole_, joined_.blend).made();
        if (channel) all.push_back(std::move(*channel));
        else added = tl::unexpected(std::move(channel.error()));
      };
      const auto of_joint = [](const auto& channels, std::size_t joint) {
        const auto found = std::ranges::find(channels, joint, [](const auto& channel) { return channel.joint; });
        return found == channels.end() ? nullptr : &*found;
      };
      for (const auto& channel : ours) {
        const auto* const other = of_joint(theirs, channel.joint);
        add(channel, other ? *other : rest(channel));
      }
      for (const auto& channel : theirs)
        if (!of_joint(ours, channel.joint)) add(rest(channel), channel);
    };
    each(first_.rotations, second_.rotations, joined_.clip.rotations,
         [&](const RotationChannel& c) { return resting(skeleton_, c, whole_.start); });
    const auto vectors = [&](Eigen::Vector3d JointPose::*part) {
      return [this, part](const VectorChannel& c) {
        return VectorChannel{.joint = c.joint,
                             .interpolation = ChannelInterpolation::linear,
                             .times = std::vector<double>(1, whole_.start),
                             .values = std::vector<Eigen::Vector3d>(1, skeleton_[c.joint].rest.*part)};
      };
    };
    each(first_.translations, second_.translations, joined_.clip.translations, vectors(&JointPose::translation));
    each(first_.scales, second_.scales, joined_.clip.scales, vectors(&JointPose::scale));
    join_weights(each);
    return added.map([&] { return std::move(joined_); });
  }

 private:
  /// Of the first clip. Where the second one has none, they stay at their last values.
  template <class Each>
  void join_weights(const Each& each) {
    const auto held_at_end = [&](const VectorChannel& c) {
      return VectorChannel{.joint = c.joint,
                           .interpolation = ChannelInterpolation::linear,
                           .times = std::vector<double>(1, whole_.start),
                           .values = std::vector<Eigen::Vector3d>(1, c.values.back())};
    };
    for (const WeightChannels& ours : first_.weights) {
      const auto theirs = std::ranges::find(second_.weights, ours.joint, &WeightChannels::joint);
      const bool goes_on = theirs != second_.weights.end() && theirs->count == ours.count;
      auto& all = joined_.clip.weights.emplace_back(WeightChannels{ours.joint, ours.count}).triples;
      for (std::size_t k = 0; k < ours.triples.size(); ++k)
        each(std::span(&ours.triples[k], 1), std::span(&(goes_on ? *theirs : ours).triples[k], goes_on ? 1 : 0), all,
             held_at_end);
    }
  }

  /// The key of the first clip there, where one is that near.
  [[nodiscard]] double frame_near(double time) const {
    const std::vector<double> times = key_times(first_);
    const auto nearest = std::ranges::min_element(times, {}, [&](double t) { return std::abs(t - time); });
    const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    return std::abs(*nearest - time) <= same_frame * step ? *nearest : time;
  }

  /// Keys at the end of the blend but for rounding are there, so that there are no two.
  template <class Channels>
  void meet_frame(Channels& channels) const {
    const double rounding = 0x1p-20 * std::max(std::abs(joined_.blend.end), 1.0);
    for (auto& channel : channels)
      for (double& time : channel.times)
        if (std::abs(time - joined_.blend.end) <= rounding) time = joined_.blend.end;
  }

  [[nodiscard]] std::size_t root() const {
    if (options_.root != no_parent) return options_.root;
    std::size_t first = no_parent;
    for (const VectorChannel& channel : first_.translations) first = std::min(first, channel.joint);
    return first;
  }

  /// The highest joint that either clip moves, of a joint and those above it.
  [[nodiscard]] std::size_t topmost_moved(std::size_t joint) const {
    return std::min(carriers_of(skeleton_, first_, joint).back(), carriers_of(skeleton_, second_, joint).back());
  }

  /// Those that take all with them that goes somewhere: that of the root, and what others there are beside it.
  [[nodiscard]] std::vector<std::size_t> moved_as_a_whole(std::size_t root) const {
    std::vector<std::size_t> joints{topmost_moved(root)};
    for (const Clip* const clip : {&first_, static_cast<const Clip*>(&second_)})
      for (const VectorChannel& channel : clip->translations)
        if (!rests(channel)) joints.push_back(topmost_moved(channel.joint));
    std::ranges::sort(joints);
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    return joints;
  }

  void place() {
    const std::size_t joint = root();
    if (joint == no_parent) return;
    const double middle = 0.5 * (joined_.blend.start + joined_.blend.end);
    const ClipMotion second(skeleton_, second_);
    const Eigen::Affine3d to = placed(ClipMotion(skeleton_, first_), joint, middle),
                          from = placed(second, joint, middle);
    const Eigen::Vector3d& up = options_.up;
    joined_.turn = heading_between(up, from, to);
    Eigen::Affine3d by(exp<double>(Eigen::Vector3d(joined_.turn * up)));
    const Eigen::Vector3d across = to.translation() - by * from.translation();
    by.pretranslate(across - up * up.dot(across));
    for (const std::size_t moved : moved_as_a_whole(joint)) {
      const std::size_t parent = skeleton_[moved].parent;
      const Eigen::Affine3d frame =
          parent == no_parent ? Eigen::Affine3d::Identity() : second.world_pose(parent, middle);
      const Eigen::Affine3d inside = frame.inverse() * by * frame;
      if (inside.matrix().allFinite()) move(moved, inside);  // there is no place below a scale of 0
    }
  }

  /// A joint of the second clip, in the frame of its parent.
  void move(std::size_t joint, const Eigen::Affine3d& by) {
    const Eigen::Quaterniond turn = quaternion_from_matrix(Eigen::Matrix3d(by.linear())).normalized();
    const JointPose& rest = skeleton_[joint].rest;
    const double start = second_.domain().start;
    if (!channel_of(second_.rotations, joint) && angular_distance(turn, Eigen::Quaterniond::Identity()) > 0.0)
      second_.rotations.push_back({.joint = joint,
                                   .times = std::vector<double>(1, start),
                                   .values = std::vector<Eigen::Quaterniond>(1, rest.rotation)});
    if (!channel_of(second_.translations, joint) && !is_near(by * rest.translation, rest.translation))
      second_.translations.push_back({.joint = joint,
                                      .times = std::vector<double>(1, start),
                                      .values = std::vector<Eigen::Vector3d>(1, rest.translation)});
    for (RotationChannel& channel : second_.rotations)
      if (channel.joint == joint)
        for (SharedList<Eigen::Quaterniond>* const list :
             {&channel.values, &channel.in_tangents, &channel.out_tangents})
          for (Eigen::Quaterniond& q : *list) q = turn * q;
    for (VectorChannel& channel : second_.translations)
      if (channel.joint == joint) {
        for (Eigen::Vector3d& v : channel.values) v = by * v;
        for (SharedList<Eigen::Vector3d>* const list : {&channel.in_tangents, &channel.out_tangents})
          for (Eigen::Vector3d& v : *list) v = by.linear() * v;
      }
  }

  const Skeleton& skeleton_;
  const Clip& first_;
  Clip second_;
  JoinOptions options_;
  Domain whole_{0.0, 0.0};
  JoinedClip joined_{};
};

}  // namespace

AnyCurve blended(const AnyCurve& from, const AnyCurve& to, Domain over) {
  return BlendedChannel<Eigen::Quaterniond>(from, to, over);
}
AnyPath blended(const AnyPath& from, const AnyPath& to, Domain over) {
  return BlendedChannel<Eigen::Vector3d>(from, to, over);
}

Expected<Clip> with_joints_of(const Skeleton& skeleton, const Clip& clip, const Skeleton& other, const Clip& of_other) {
  const Counterparts same = counterparts_of(skeleton, other);
  const std::vector<bool> ours = moved_in(skeleton, clip), theirs = moved_in(other, of_other);
  std::vector<std::size_t> place(other.size(), no_parent);
  for (std::size_t joint = 0; joint < skeleton.size(); ++joint) {
    const std::size_t there = same.joints[joint];
    if (there != no_parent) place[there] = joint;
    const bool counts = ours[joint] || (there != no_parent && theirs[there]);
    if (!counts) continue;
    if (there == no_parent) return unlike(skeleton, joint, "no such joint in the second file");
    if (have_one_pose(skeleton[joint].rest, other[there].rest)) continue;
    const double angle = angular_distance(skeleton[joint].rest.rotation, other[there].rest.rotation) * degrees;
    const double way = (skeleton[joint].rest.translation - other[there].rest.translation).norm();
    return unlike(skeleton, joint, formatted("rest poses that differ by {:.4g}° and {:.4g} of length", angle, way));
  }
  for (std::size_t there = 0; there < other.size(); ++there)
    if (theirs[there] && place[there] == no_parent) return unlike(other, there, "no such joint in the first file");
  Clip moved = of_other;
  const auto put = [&](auto& channels) {
    for (auto& channel : channels) channel.joint = place[channel.joint];
  };
  put(moved.rotations);
  put(moved.translations);
  put(moved.scales);
  std::erase_if(moved.weights, [&](const WeightChannels& weights) { return place[weights.joint] == no_parent; });
  for (WeightChannels& weights : moved.weights) {
    weights.joint = place[weights.joint];
    put(weights.triples);
  }
  return moved;
}

Expected<JoinedClip> joined(const Skeleton& skeleton, const Clip& first, const Clip& second,
                            const JoinOptions& options) {
  return ClipJoin(skeleton, first, second, options).made();
}

}}  // namespace orispline
