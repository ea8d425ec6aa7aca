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
#include <orispline/edit/up_axis.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t fewest_times = 3;
constexpr double closed_within = 1e-4;    // [rad], or of the extent of vectors: what a file's digits may open
constexpr double stored_within = 1e-6;    // the same, and per second, where a file states what lies between its keys
constexpr double usual_jump = 1.5;        // times a large jump of the rate between two steps inside of the clip
constexpr double cubic_tolerance = 1e-5;  // [rad]
constexpr double window_steps = 4.0, least_window = 0.25;  // of corrections: steps between keys, and [s]

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
  if (channel.interpolation == ChannelInterpolation::step || rests(channel)) return true;
  const double unit = unit_of(channel), open = gap(channel.values.back(), channel.values.front(), step).norm();
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

/// With its first value once more, one step behind its end.
template <CurvePoint P>
Channel<P> with_frame(Channel<P> channel, const LoopStep& step) {
  const std::size_t last = channel.size() - 2;
  const double time = channel.times[last + 1] + (channel.times[last + 1] - channel.times[last]);
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

template <CurvePoint P>
Expected<AnyCurveThrough<P>> bent(const Channel<P>& channel, Domain domain, const LoopStep& step) {
  const bool spans = channel.times.front() <= domain.start && channel.times.back() >= domain.end;
  return meant_curve(spans ? channel : part_of(channel, domain.start, domain.end)).map([&](const auto& curve) {
    const auto correction = correction_of(motion_at(curve, domain.start), motion_at(curve, domain.end, Side::left),
                                          step, domain, bend_times(channel, domain));
    return AnyCurveThrough<P>(CorrectedCurve<P>(curve, correction, domain));
  });
}

/// Where a joint's travel leads, from its ends.
struct RootSteps {
  LoopStep rotation{}, translation{};
  double turn = 0.0;  ///< [rad]
};

RootSteps root_steps(const Vector3d& up, const Quaterniond& start, const Quaterniond& end) {
  const double turn = heading_of(up, end * start.conjugate());
  const Quaterniond about_up = exp<double>(Vector3d(turn * up));
  return {{about_up, {}}, {about_up, up}, turn};
}

/// Makes one clip a loop.
class Looper {
 public:
  Looper(const Skeleton& skeleton, const Clip& clip, const LoopRoot& root, ClosingKey key)
      : clip_(clip), domain_(clip.domain()), root_(root.joint), key_(key) {
    loop_.clip = {.name = clip.name, .passed_on = clip.passed_on};
    if (root_ == no_parent) return;
    up_ = up_in_parent(skeleton, clip, root_, root.up);
    const RotationChannel* const channel = channel_of(clip.rotations, root_);
    ends_ = frame_ends_ = root_steps(up_, Quaterniond::Identity(), Quaterniond::Identity());
    if (!channel || channel->size() < 2) return;
    const ChannelCurve<Quaterniond> curve(*channel);
    ends_ = root_steps(up_, curve.at(domain_.start), curve.at(domain_.end));
    frame_ends_ = root_steps(up_, channel->values.front(), foretold(*channel, {}));
  }

  Expected<ClipLoop> made() && {
    if (all([&](const auto& channel) { return goes_round(channel, step_for(channel, ends_)); })) {
      add([&](const auto& channel) { return Expected<std::remove_cvref_t<decltype(channel)>>(channel); });
    } else if (key_ == ClosingKey::may_lack && end_together() &&
               all([&](const auto& c) { return lacks_frame(c, step_for(c, frame_ends_)); })) {
      loop_.closing = LoopClosing::frame;
      std::swap(ends_, frame_ends_);
      add([&](const auto& channel) {
        return Expected<std::remove_cvref_t<decltype(channel)>>(
            channel.size() == 1 ? channel : with_frame(channel, step_for(channel, ends_)));
      });
    } else {
      loop_.closing = LoopClosing::bent;
      add([&](const auto& channel) { return bent_channel(channel, step_for(channel, ends_)); });
    }
    loop_.turn = ends_.turn;
    loop_.root_turn = ends_.rotation.turn;
    if (const VectorChannel* const path = channel_of(loop_.clip.translations, root_)) {
      const Vector3d way = path->values.back() - path->values.front();
      loop_.travel = (way - up_ * up_.dot(way)).norm();
    }
    return std::move(checked_).or_else(std::move(loop_));
  }

 private:
  [[nodiscard]] LoopStep step_for(const RotationChannel& channel, const RootSteps& ends) const {
    return channel.joint == root_ ? ends.rotation : LoopStep{};
  }
  [[nodiscard]] LoopStep step_for(const VectorChannel& channel, const RootSteps& ends) const {
    const bool is_path = channel.joint == root_ && channel_of(clip_.translations, root_) == &channel;
    return is_path ? ends.translation : LoopStep{};
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
      const double own = channel.times.back() - channel.times[channel.size() - 2];
      if (interval == 0.0) interval = own;
      return channel.times.back() == domain_.end && std::abs(own - interval) <= 1e-3 * interval;
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

  template <CurvePoint P>
  Expected<Channel<P>> bent_channel(const Channel<P>& channel, const LoopStep& step) {
    Channel<P> part = part_of(channel, domain_.start, domain_.end);
    if (goes_round(part, step)) return part;
    if (channel.interpolation == ChannelInterpolation::step) {
      part.values.back() = part.values.front();
      return part;
    }
    return bent(channel, domain_, step).map([&](const AnyCurveThrough<P>& curve) {
      Channel<P> made = part;
      if (channel.interpolation == ChannelInterpolation::cubicspline) {
        made = cubic_channel(curve, cubic_tolerance * unit_of(channel)).channel;
        made.joint = channel.joint;
      } else {
        for (std::size_t i = 0; i < made.size(); ++i) made.values[i] = point_of(motion_at(curve, made.times[i]));
      }
      if (!is_weight(channel)) note_change(part, curve);
      made.values.back() = with_sign_near(again(made, made.values.back(), step), made.values.back());
      return made;
    });
  }

  template <CurvePoint P>
  void note_change(const Channel<P>& before, const AnyCurveThrough<P>& after) {
    LoopChange& change = std::same_as<P, Quaterniond> ? loop_.rotation : loop_.translation;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double moved = distance_between(before.values[i], point_of(motion_at(after, before.times[i])));
      if (moved > change.largest.value) change = {{moved, before.times[i]}, before.joint};
    }
  }

  const Clip& clip_;
  Domain domain_;
  std::size_t root_;
  ClosingKey key_;
  Vector3d up_ = Vector3d::UnitY();
  RootSteps ends_{}, frame_ends_{};
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
