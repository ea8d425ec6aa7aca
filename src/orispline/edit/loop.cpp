// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/loop.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/first_error.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/edit/correction.hpp>
#include <orispline/edit/cut.hpp>
#include <orispline/edit/linear_keys.hpp>
#include <orispline/edit/travel.hpp>
#include <orispline/edit/up_axis.hpp>
#include <orispline/math/highest.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t fewest_times = 3;
constexpr double closed_within = 1e-4;    // [rad], or of the extent of vectors: what a file's digits may open
constexpr double stored_within = 1e-6;    // the same, and per second, where a file states what lies between its keys
constexpr double usual_jump = 1.5;        // times a large jump of the rate between two steps inside of the clip
constexpr double cubic_tolerance = 1e-5;  // [rad]
constexpr double window_steps = 4.0, least_window = 0.25;  // of corrections: steps between keys, and [s]
constexpr double fewest_steps = 16.0;                      // of a linear channel that shall follow a correction
constexpr double same_interval = 1e-3;                     // share by which two are one but for rounding

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// How large a difference of values is that is none.
double unit_of(const RotationChannel&) { return 1.0; }
double unit_of(const VectorChannel& channel) {
  double largest = 0.0;
  for (const Vector3d& value : channel.values) largest = std::max(largest, (value - channel.values.front()).norm());
  return largest;
}

/// From the end of a loop to its start.
Vector3d gap(const Quaterniond& end, const Quaterniond& start, const LoopStep& step) {
  return shortest_displacement(end, step.turn * start);
}
Vector3d gap(const Vector3d& end, const Vector3d& start, const LoopStep& step) {
  return step.up ? Vector3d(*step.up * step.up->dot(start - end)) : Vector3d(start - end);
}

/// A step at the start as it is seen at the end: that of a rotation is in its body frame.
Vector3d turned(const RotationChannel&, const Vector3d& rate, const LoopStep&) { return rate; }
Vector3d turned(const VectorChannel&, const Vector3d& rate, const LoopStep& step) { return step.turn * rate; }

/// The mean rate from a key to the next.
template <CurvePoint P>
Vector3d step_rate(const Channel<P>& channel, std::size_t i) {
  return shortest_displacement(channel.values[i], channel.values[i + 1]) / (channel.times[i + 1] - channel.times[i]);
}

/// The jumps from one such rate to the next, the smallest first.
template <CurvePoint P>
std::vector<double> jumps_of(const Channel<P>& channel) {
  std::vector<double> jumps;
  for (std::size_t i = 0; i + 2 < channel.size(); ++i)
    jumps.push_back((step_rate(channel, i + 1) - step_rate(channel, i)).norm());
  std::ranges::sort(jumps);
  return jumps;
}

/// How far a rate may jump at a seam: by the largest jump inside, or by one that nine in ten do not exceed, since
/// single faults tell nothing of a key that is not there.
template <CurvePoint P>
double usual_jump_of(const Channel<P>& channel, double share) {
  const std::vector<double> jumps = jumps_of(channel);
  if (jumps.empty()) return 0.0;
  return usual_jump * jumps[static_cast<std::size_t>(share * static_cast<double>(jumps.size() - 1))];
}

/// Whether it goes round as it is: the rates at its ends differ by no more than those of neighbours inside.
template <CurvePoint P>
bool goes_round(const Channel<P>& channel, const LoopStep& step) {
  if (rests(channel)) return true;
  const double unit = unit_of(channel), open = gap(channel.values.back(), channel.values.front(), step).norm();
  if (channel.interpolation == ChannelInterpolation::step) return open <= closed_within * unit;
  if (channel.interpolation == ChannelInterpolation::cubicspline) {
    const ChannelCurve<P> curve(channel);
    const MotionOf<P> start = curve.motion(channel.times.front()), end = curve.motion(channel.times.back());
    const auto rate = [](const MotionOf<P>& motion) -> Vector3d {
      if constexpr (std::same_as<P, Quaterniond>) return motion.angular_velocity;
      else return motion.velocity;
    };
    return open <= stored_within * unit &&
           (turned(channel, rate(start), step) - rate(end)).norm() <= stored_within * unit;
  }
  const std::size_t last = channel.size() - 2;
  const double interval = channel.times[last + 1] - channel.times[last];
  const double jump = (turned(channel, step_rate(channel, 0), step) - step_rate(channel, last)).norm();
  return open <= closed_within * unit && jump <= usual_jump_of(channel, 1.0) + closed_within * unit / interval;
}

/// What a channel would be at the next key if it went on as it ends and as it begins.
template <CurvePoint P>
P foretold(const Channel<P>& channel, const LoopStep& step) {
  const std::size_t last = channel.size() - 2;
  const double interval = channel.times[last + 1] - channel.times[last];
  const Vector3d rate = 0.5 * (step_rate(channel, last) + turned(channel, step_rate(channel, 0), step));
  return displaced<double>(channel.values.back(), interval * rate);
}

/// The first value again.
Quaterniond again(const RotationChannel& channel, const Quaterniond&, const LoopStep& step) {
  return step.turn * channel.values.front();
}
Vector3d again(const VectorChannel& channel, const Vector3d& end, const LoopStep& step) {
  return end + gap(end, channel.values.front(), step);
}

/// From its last key but one to its last one [s].
template <CurvePoint P>
double last_interval(const Channel<P>& channel) {
  return channel.times.back() - channel.times[channel.size() - 2];
}

/// With its first value once more, one step behind its end.
template <CurvePoint P>
Channel<P> with_frame(Channel<P> channel, const LoopStep& step) {
  const double time = channel.times.back() + last_interval(channel);
  P value = channel.interpolation == ChannelInterpolation::step ? channel.values.front()
                                                                : again(channel, foretold(channel, step), step);
  channel.values.push_back(with_sign_near(value, channel.values.back()));
  channel.times.push_back(time);
  return channel;
}

/// Whether the first value again fits one step behind the end.
template <CurvePoint P>
bool lacks_frame(const Channel<P>& channel, const LoopStep& step) {
  if (channel.interpolation == ChannelInterpolation::step || rests(channel)) return true;
  if (channel.interpolation == ChannelInterpolation::cubicspline || channel.size() < fewest_times) return false;
  const Channel<P> whole = with_frame(channel, step);
  const std::size_t last = whole.size() - 2;
  const double limit =
      usual_jump_of(channel, 0.9) + closed_within * unit_of(channel) / (whole.times[last + 1] - whole.times[last]);
  const Vector3d closing = step_rate(whole, last);
  return (closing - step_rate(whole, last - 1)).norm() <= limit &&
         (turned(channel, step_rate(channel, 0), step) - closing).norm() <= limit;
}

template <CurvePoint P>
BendTimes bend_times(const Channel<P>& channel, Domain domain) {
  const double length = domain.end - domain.start;
  const auto inside = std::ranges::count_if(channel.times, [&](double t) { return domain.contains(t); });
  const double steps = window_steps * length / std::max(1.0, static_cast<double>(inside - 1));
  const double rate = std::min(0.5 * length, std::max(steps, least_window));
  return {rate, std::min(rate, steps)};
}

/// The mean of both ends, each as it is once its value is that of the middle.
Correction correction_of(const Motion& start, const Motion& end, const LoopStep& step, Domain domain, BendTimes times) {
  const Vector3d half = 0.5 * gap(end.orientation, start.orientation, step);
  const auto met = [&](const Vector3d& at_start, const Vector3d& at_end) -> Vector3d {
    return 0.5 * (to_body<double>(exp<double>(-half), at_start) + to_body<double>(exp<double>(half), at_end));
  };
  const Vector3d rate = met(start.angular_velocity, end.angular_velocity),
                 acceleration = met(start.angular_acceleration, end.angular_acceleration);
  return {domain, bend_to(start, -half, rate, acceleration), bend_to(end, half, rate, acceleration), times};
}
Correction correction_of(const LinearMotion& start, const LinearMotion& end, const LoopStep& step, Domain domain,
                         BendTimes times) {
  const Vector3d half = 0.5 * gap(end.position, start.position, step);
  const auto met = [&](const Vector3d& at_start, const Vector3d& at_end) -> Vector3d {
    return 0.5 * (at_start + step.turn.conjugate() * at_end);
  };
  const Vector3d rate = met(start.velocity, end.velocity), acceleration = met(start.acceleration, end.acceleration);
  return {domain, bend_to(start, -half, rate, acceleration),
          bend_to(end, half, step.turn * rate, step.turn * acceleration), times};
}

/// The motion that a channel means, and what closes that.
template <CurvePoint P>
struct Bending {
  AnyCurveThrough<P> curve;
  Correction correction;
};

template <CurvePoint P>
Expected<Bending<P>> bending_of(const Channel<P>& channel, Domain domain, const LoopStep& step) {
  const bool spans = channel.times.front() <= domain.start && channel.times.back() >= domain.end;
  return meant_curve(spans ? channel : part_of(channel, domain.start, domain.end)).map([&](const auto& curve) {
    return Bending<P>{curve, correction_of(motion_at(curve, domain.start), motion_at(curve, domain.end, Side::left),
                                           step, domain, bend_times(channel, domain))};
  });
}

template <CurvePoint P>
Expected<AnyCurveThrough<P>> bent(const Channel<P>& channel, Domain domain, const LoopStep& step) {
  return bending_of(channel, domain, step).map([&](const Bending<P>& bending) {
    return AnyCurveThrough<P>(CorrectedCurve<P>(bending.curve, bending.correction, domain));
  });
}

template <CurvePoint P>
AnyCurveThrough<P> stored_curve(const Channel<P>& channel) {
  return StoredCurve<P>{ChannelCurve<P>(channel).curve()};
}

/// A linear channel with a correction: its keys, and those that it takes to follow it.
template <CurvePoint P>
Channel<P> bent_keys(const Channel<P>& channel, const Correction& correction, Domain domain) {
  const AnyCurveThrough<P> curve = CorrectedCurve<P>(stored_curve(channel), correction, domain);
  Channel<P> made{.joint = channel.joint, .interpolation = ChannelInterpolation::linear};
  made.times.push_back(domain.start);
  made.values.push_back(point_of(motion_at(curve, domain.start)));
  LinearKeys<P> keys(made, curve);
  for (const double t : channel.times)
    if (t > domain.start) keys.go_to(t, (domain.end - domain.start) / fewest_steps);
  return made;
}

/// Where a joint's travel leads, from its ends.
struct RootSteps {
  LoopStep rotation{}, translation{};
};

RootSteps root_steps(const Vector3d& up, const Quaterniond& start, const Quaterniond& end) {
  const Quaterniond about_up = exp<double>(Vector3d(heading_of(up, end * start.conjugate()) * up));
  return {{about_up, {}}, {about_up, up}};
}

/// A joint whose travel is kept, where the loop ends with the clip and where it ends one step later.
struct Carrier {
  std::size_t joint;
  RootSteps ends, frame_ends;
};

Carrier carrier_of(const Skeleton& skeleton, const Clip& clip, std::size_t joint, const Vector3d& up_in_world) {
  const Vector3d up = up_in_parent(skeleton, clip, joint, up_in_world);
  const RootSteps none = root_steps(up, Quaterniond::Identity(), Quaterniond::Identity());
  const RotationChannel* const channel = channel_of(clip.rotations, joint);
  if (!channel || channel->size() < 2) return {joint, none, none};
  const ChannelCurve<Quaterniond> curve(*channel);
  const Domain domain = clip.domain();
  return {joint, root_steps(up, curve.at(domain.start), curve.at(domain.end)),
          root_steps(up, channel->values.front(), foretold(*channel, {}))};
}

/// Makes one clip a loop.
class Looper {
 public:
  Looper(const Skeleton& skeleton, const Clip& clip, const LoopRoot& root, ClosingKey key)
      : skeleton_(skeleton), clip_(clip), moving_(skeleton, clip), domain_(clip.domain()), root_(root), key_(key) {
    loop_.clip = {.name = clip.name, .passed_on = clip.passed_on};
    if (root.joint == no_parent) return;
    for (const std::size_t joint : carriers_of(skeleton, clip, root.joint))
      carriers_.push_back(carrier_of(skeleton, clip, joint, root.up));
  }

  Expected<ClipLoop> made() && {
    const auto ends = &Carrier::ends, frame_ends = &Carrier::frame_ends;
    auto chosen = ends;
    if (all([&](const auto& channel) { return goes_round(channel, step_for(channel, ends)); })) {
      add([&](const auto& channel) { return Expected<std::remove_cvref_t<decltype(channel)>>(channel); });
    } else if (key_ == ClosingKey::may_lack && end_together() &&
               all([&](const auto& c) { return lacks_frame(c, step_for(c, frame_ends)); })) {
      loop_.closing = LoopClosing::frame;
      chosen = frame_ends;
      add([&](const auto& channel) {
        return Expected<std::remove_cvref_t<decltype(channel)>>(
            channel.size() == 1 ? channel : with_frame(channel, step_for(channel, frame_ends)));
      });
    } else {
      loop_.closing = LoopClosing::frame;
      add([&](const auto& channel) { return closed(channel, step_for(channel, ends), step_for(channel, frame_ends)); });
    }
    auto sound = std::move(checked_).or_else(true);
    if (!sound) return tl::unexpected(std::move(sound.error()));
    for (const Carrier& carrier : carriers_) loop_.turns.push_back({carrier.joint, (carrier.*chosen).rotation.turn});
    if (root_.joint == no_parent) return std::move(loop_);
    const Travel travel = travel_of(skeleton_, loop_.clip, root_.joint, root_.up);
    loop_.travel = travel.way;
    loop_.turn = travel.turn;
    return std::move(loop_);
  }

 private:
  using Ends = RootSteps Carrier::*;

  [[nodiscard]] LoopStep step_for(const RotationChannel& channel, Ends ends) const {
    const auto carrier = std::ranges::find(carriers_, channel.joint, &Carrier::joint);
    return carrier == carriers_.end() ? LoopStep{} : ((*carrier).*ends).rotation;
  }
  [[nodiscard]] LoopStep step_for(const VectorChannel& channel, Ends ends) const {
    const auto carrier = std::ranges::find(carriers_, channel.joint, &Carrier::joint);
    return carrier != carriers_.end() && is_path(channel) ? ((*carrier).*ends).translation : LoopStep{};
  }

  [[nodiscard]] static bool is_weight(const RotationChannel&) { return false; }
  [[nodiscard]] bool is_weight(const VectorChannel& channel) const {
    return std::ranges::any_of(clip_.weights, [&](const WeightChannels& weights) {
      return !weights.triples.empty() && &channel >= &weights.triples.front() && &channel <= &weights.triples.back();
    });
  }

  template <class Holds>
  [[nodiscard]] bool all(const Holds& holds) const {
    return std::ranges::all_of(clip_.rotations, holds) && std::ranges::all_of(clip_.translations, holds) &&
           std::ranges::all_of(clip_.scales, holds) &&
           std::ranges::all_of(clip_.weights, [&](const WeightChannels& weights) {
             return std::ranges::all_of(weights.triples, holds);
           });
  }

  /// Whether all channels of more than one key end at one time, after one interval.
  [[nodiscard]] bool end_together() const {
    double interval = 0.0;
    return all([&](const auto& channel) {
      if (channel.size() == 1) return true;
      const double own = last_interval(channel);
      if (interval == 0.0) interval = own;
      return channel.times.back() == domain_.end && std::abs(own - interval) <= same_interval * interval;
    });
  }

  template <class Change>
  void add(const Change& change) {
    const auto each = [&](const auto& channels, auto& made) {
      for (const auto& channel : channels) made.push_back(checked_(change(channel)));
    };
    each(clip_.rotations, loop_.clip.rotations);
    each(clip_.translations, loop_.clip.translations);
    each(clip_.scales, loop_.clip.scales);
    for (const WeightChannels& weights : clip_.weights)
      each(weights.triples, loop_.clip.weights.emplace_back(WeightChannels{weights.joint, weights.count}).triples);
  }

  /// Whether it ends one step before the clip.
  template <CurvePoint P>
  [[nodiscard]] bool ends_early(const Channel<P>& channel) const {
    if (channel.size() == 1 || channel.times.front() > domain_.start) return false;
    const double interval = last_interval(channel), left = domain_.end - channel.times.back();
    return std::abs(left - interval) <= same_interval * interval;
  }

  /// As it is where it goes round, else with its first value at the end of the clip, else bent.
  template <CurvePoint P>
  Expected<Channel<P>> closed(const Channel<P>& channel, const LoopStep& step, const LoopStep& frame_step) {
    const Channel<P> part = part_of(channel, domain_.start, domain_.end);
    if (goes_round(part, step)) return part;
    if (key_ == ClosingKey::may_lack && ends_early(channel) && lacks_frame(channel, frame_step)) {
      Channel<P> whole = with_frame(channel, frame_step);
      whole.times.back() = domain_.end;
      return whole;
    }
    Channel<P> made = part;
    if (channel.interpolation != ChannelInterpolation::step) {
      const auto bending = bending_of(channel, domain_, step);
      if (!bending) return tl::unexpected(bending.error());
      made = bent_channel(part, *bending);
      if (!is_weight(channel)) note_change(channel, part, made);
      loop_.closing = LoopClosing::bent;
    }
    made.values.back() = with_sign_near(again(made, made.values.back(), step), made.values.back());
    return made;
  }

  template <CurvePoint P>
  Channel<P> bent_channel(const Channel<P>& part, const Bending<P>& bending) const {
    if (part.interpolation == ChannelInterpolation::linear) return bent_keys(part, bending.correction, domain_);
    const AnyCurveThrough<P> curve = CorrectedCurve<P>(bending.curve, bending.correction, domain_);
    Channel<P> made = cubic_channel(curve, cubic_tolerance * unit_of(part)).channel;
    made.joint = part.joint;
    return made;
  }

  [[nodiscard]] bool is_path(const RotationChannel&) const { return false; }
  [[nodiscard]] bool is_path(const VectorChannel& channel) const {
    return channel_of(clip_.translations, channel.joint) == &channel;
  }

  /// How far two values at a time are from each other; of positions in the world.
  [[nodiscard]] double change_of(const RotationChannel&, const Quaterniond& before, const Quaterniond& after,
                                 double) const {
    return angular_distance(before, after);
  }
  [[nodiscard]] double change_of(const VectorChannel& channel, const Vector3d& before, const Vector3d& after,
                                 double t) const {
    const std::size_t parent = skeleton_[channel.joint].parent;
    if (!is_path(channel) || parent == no_parent) return (after - before).norm();
    return (moving_.world_pose(parent, t).linear() * (after - before)).norm();
  }

  template <CurvePoint P>
  void note_change(const Channel<P>& channel, const Channel<P>& before, const Channel<P>& after) {
    constexpr int looks = 4;  // from key to key
    const ChannelCurve<P> was(before), is(after);
    const auto change_at = [&](double t) { return change_of(channel, was.at(t), is.at(t), t); };
    SummitsInPassing changes;
    for (std::size_t i = 0; i + 1 < after.size(); ++i)
      for (int k = 0; k < looks; ++k) {
        const double t = after.times[i] + (after.times[i + 1] - after.times[i]) * k / looks;
        changes.pass({t, change_at(t)});
      }
    changes.pass({domain_.end, change_at(domain_.end)});
    LoopChange& change = std::same_as<P, Quaterniond> ? loop_.rotation
                         : is_path(channel)           ? loop_.translation
                                                      : loop_.scale;
    const Height top = changes.highest(change_at, change.largest.value);
    if (top.value > change.largest.value) change = {{top.value, top.place}, channel.joint};
  }

  const Skeleton& skeleton_;
  const Clip& clip_;
  ClipMotion moving_;
  Domain domain_;
  LoopRoot root_;
  ClosingKey key_;
  std::vector<Carrier> carriers_{};
  ClipLoop loop_{};
  FirstError checked_{};
};

}  // namespace

Expected<ClipLoop> looped(const Skeleton& skeleton, const Clip& clip, const LoopRoot& root, ClosingKey key) {
  const std::size_t times = key_times(clip).size();
  if (times < fewest_times)
    return failure(ErrorCode::bad_data, formatted("clip {}: found keys at {}, wanted {} at least for a loop",
                                                  in_quotes(clip.name), counted(times, "time"), fewest_times));
  return Looper(skeleton, clip, root, key).made();
}

Expected<AnyCurve> bent_curve(const RotationChannel& channel, Domain domain, const LoopStep& step) {
  return bent(channel, domain, step);
}
Expected<AnyPath> bent_curve(const VectorChannel& channel, Domain domain, const LoopStep& step) {
  return bent(channel, domain, step);
}

}}  // namespace orispline
