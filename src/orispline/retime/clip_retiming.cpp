// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/clip_retiming.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_clock.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/retime/interval_times.hpp>
#include <orispline/retime/retimed_method.hpp>
#include <orispline/retime/slowed.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Joints whose linear channels have the same key times.
struct Group {
  std::vector<std::size_t> joints{};
  std::vector<Keyframes> bodies{};
};

template <CurvePoint P>
bool is_moved_by(const Channel<P>* channel, ChannelInterpolation interpolation) {
  return channel && channel->size() > 1 && channel->interpolation == interpolation;
}

/// Joins the bodies of a clip that have the same key times.
class Groups {
 public:
  [[nodiscard]] std::vector<Group> taken() && { return std::move(groups_); }

  Expected<void> add(const RotationChannel* rotation, const VectorChannel* translation) {
    const bool turns = is_moved_by(rotation, ChannelInterpolation::linear),
               moves = is_moved_by(translation, ChannelInterpolation::linear);
    if (turns && moves && rotation->times == translation->times)
      return add(rotation->joint,
                 {.times = rotation->times, .orientations = rotation->values, .positions = translation->values});
    Expected<void> added{};
    if (turns)
      added =
          add(rotation->joint, {.times = rotation->times,
                                .orientations = rotation->values,
                                .positions = std::vector<Eigen::Vector3d>(rotation->size(), Eigen::Vector3d::Zero())});
    if (added && moves)
      added = add(translation->joint,
                  {.times = translation->times,
                   .orientations = std::vector<Eigen::Quaterniond>(translation->size(), Eigen::Quaterniond::Identity()),
                   .positions = translation->values});
    return added;
  }

 private:
  Expected<void> add(std::size_t joint, KeyframeData data) {
    return Keyframes::make(std::move(data)).map([&](Keyframes keys) {
      const auto same = std::ranges::find_if(
          groups_, [&](const Group& group) { return std::ranges::equal(group.bodies.front().times(), keys.times()); });
      Group& group = same == groups_.end() ? groups_.emplace_back() : *same;
      group.joints.push_back(joint);
      group.bodies.push_back(std::move(keys));
    });
  }

  std::vector<Group> groups_{};
};

Eigen::Vector3d vector_of(const Motion& motion, LimitedQuantity::Vector vector) {
  using Vector = LimitedQuantity::Vector;
  return vector == Vector::rate           ? motion.angular_velocity
         : vector == Vector::acceleration ? motion.angular_acceleration
         : vector == Vector::jerk         ? motion.angular_jerk
                                          : Eigen::Vector3d::Zero();
}
Eigen::Vector3d vector_of(const LinearMotion& motion, LimitedQuantity::Vector vector) {
  using Vector = LimitedQuantity::Vector;
  return vector == Vector::speed                 ? motion.velocity
         : vector == Vector::linear_acceleration ? motion.acceleration
                                                 : Eigen::Vector3d::Zero();
}

/// The largest of a cubic that were found, in the place of bounds.
template <CurvePoint P>
SegmentPeaks measured_peaks(const Channel<P>& channel, const std::vector<LimitedQuantity>& quantities) {
  constexpr std::size_t parts = 16;  // of a segment
  const ChannelCurve<P> curve(channel);
  SegmentPeaks peaks(quantities.size(), CertifiedPeak{.body = channel.joint});
  for (std::size_t s = 0; s + 1 < channel.size(); ++s)
    for (std::size_t i = 0; i <= parts; ++i) {
      const double share = static_cast<double>(i) / double{parts};
      const double t = channel.times[s] + share * (channel.times[s + 1] - channel.times[s]);
      const MotionOf<P> motion = curve.curve().motion(t, s);
      for (std::size_t k = 0; k < quantities.size(); ++k)
        if (const double size = quantities[k].size_of(vector_of(motion, quantities[k].vector)); size > peaks[k].found)
          peaks[k].found = peaks[k].bound = size, peaks[k].time = t;
    }
  return peaks;
}

QuantitySizes found_in(const SegmentPeaks& peaks) {
  QuantitySizes sizes{};
  std::ranges::transform(peaks, sizes.begin(), [](const CertifiedPeak& peak) { return peak.found; });
  return sizes;
}

/// Seeks the clock of one clip.
class ClipSlowing {
 public:
  ClipSlowing(const Clip& clip, const Method& method, const FamilyInfo& family, const RetimeOptions& options,
              OpenEndedWork& work)
      : clip_(clip), method_(method), family_(family), options_(options), work_(work) {}

  Expected<ClipRetiming> made() {
    return gather().and_then([&] { return check(); }).and_then([&] {
      return groups_.size() == 1 && cubics_.empty() ? on_clock_of_keys() : scaled();
    });
  }

 private:
  Expected<void> gather() {
    Groups groups;
    std::vector<std::size_t> joints;
    for (const RotationChannel& channel : clip_.rotations) joints.push_back(channel.joint);
    for (const VectorChannel& channel : clip_.translations)
      if (!channel_of(clip_.rotations, channel.joint)) joints.push_back(channel.joint);
    for (const std::size_t joint : joints) {
      const RotationChannel* const rotation = channel_of(clip_.rotations, joint);
      const VectorChannel* const translation = channel_of(clip_.translations, joint);
      if (auto added = groups.add(rotation, translation); !added) return added;
      if (is_moved_by(rotation, ChannelInterpolation::cubicspline))
        cubics_.push_back(measured_peaks(*rotation, quantities_));
      if (is_moved_by(translation, ChannelInterpolation::cubicspline))
        cubics_.push_back(measured_peaks(*translation, quantities_));
    }
    groups_ = std::move(groups).taken();
    return {};
  }

  [[nodiscard]] Expected<void> check() const {
    const Domain domain = clip_.domain();
    if (!(domain.start < domain.end)) return failure(ErrorCode::bad_data, "found no channel of two keys, wanted one");
    const bool is_one_clock = groups_.size() == 1 && cubics_.empty();
    if (!is_one_clock && (options_.slowing != Slowing::uniform || options_.shorten_rests))
      return bad_option(options_.shorten_rests ? "shorten_rests" : "slowing",
                        "found channels with keys at different times or cubics, wanted linear ones with the same "
                        "times, as `sample` with a rate writes them");
    for (const Group& group : groups_)
      for (const Keyframes& keys : group.bodies)
        if (auto sound = check_retimed(family_, method_, keys, options_); !sound) return sound;
    return {};
  }

  /// All joints have keys at the same times, which get others.
  [[nodiscard]] Expected<ClipRetiming> on_clock_of_keys() {
    const Group& group = groups_.front();
    const auto start = starting_times(group.bodies, options_);
    if (!start) return tl::unexpected(start.error());
    const auto slowed_with = [&](Rests rests) {
      const LimitedMotion motion(method_, group.bodies, options_.limits, *start, rests, work_);
      if (options_.duration) return lasting(motion, *options_.duration);
      if (!motion.is_limited()) return Expected<Slowed>(as_given(motion));
      return least_slowed(motion, family_.support_keys, options_.slowing);
    };
    auto found = slowed_with(Rests::kept);
    std::size_t rests = 0;
    for (std::size_t i = 0; i + 1 < group.bodies.front().size(); ++i) rests += all_rest_after(group.bodies, i) ? 1 : 0;
    const bool slows_rests = rests > 0 && !found && found.error().code == ErrorCode::not_converged;
    if (slows_rests) found = slowed_with(Rests::slowed);
    if (!found) return tl::unexpected(std::move(found.error()));
    ClipRetiming made{
        .time_scale = found->time_scale, .slack = found->slack, .slowing = found->slowing, .rests = rests};
    const auto before = group.bodies.front().times();
    const ClipClock clock{{before.begin(), before.end()}, found->times};
    made.time_scale = (clock.after.back() - clock.after.front()) / (before.back() - before.front());
    add_peaks(made, std::move(found->peaks), group.joints);
    if (slows_rests) made.warnings.push_back(longer_rests(method_.name));
    return finished(std::move(made), clock);
  }

  /// All times longer by one factor.
  [[nodiscard]] Expected<ClipRetiming> scaled() {
    const Domain domain = clip_.domain();
    double needed = 0.0;
    ClipRetiming made{.slowing = Slowing::uniform, .measured = cubics_.size()};
    for (const Group& group : groups_) {
      auto found = slowed_alike(group, 1.0);
      if (!found) return tl::unexpected(std::move(found.error()));
      if (found->time_scale > needed) needed = found->time_scale, made.slack = found->slack;
    }
    for (const SegmentPeaks& peaks : cubics_) needed = std::max(needed, needed_factor(found_in(peaks), quantities_));
    const double length = domain.end - domain.start;
    made.time_scale = options_.duration ? *options_.duration / length : std::max(1.0, needed);
    if (!quantities_.empty() && made.time_scale < needed)
      return bad_option("duration",
                        formatted("in {:.6g} s the motion exceeds its limits, wanted some {:.6g} s at least",
                                  *options_.duration, as_shown_or_more(needed * length)));
    for (const Group& group : groups_) {
      auto found = slowed_alike(group, made.time_scale);
      if (!found) return tl::unexpected(std::move(found.error()));
      add_peaks(made, std::move(found->peaks), group.joints);
    }
    for (SegmentPeaks peaks : cubics_) {
      for (std::size_t k = 0; k < peaks.size(); ++k)
        for (int order = 0; order < quantities_[k].order(); ++order)
          peaks[k].found = peaks[k].bound = peaks[k].found / made.time_scale;
      made.peaks.push_back(std::move(peaks));
    }
    if (!cubics_.empty() && !quantities_.empty()) made.warnings.push_back(measured());
    return finished(std::move(made),
                    {{domain.start, domain.start + length}, {domain.start, domain.start + made.time_scale * length}});
  }

  /// The keys of a group, all their times longer by a factor, slowed further where limits ask for it.
  [[nodiscard]] Expected<Slowed> slowed_alike(const Group& group, double factor) {
    StartingTimes start;
    const auto times = group.bodies.front().times();
    for (const double time : times) start.times.push_back(times.front() + factor * (time - times.front()));
    start.least.assign(times.size() - 1, 0.0);
    const LimitedMotion motion(method_, group.bodies, options_.limits, start, Rests::slowed, work_);
    if (!motion.is_limited()) return as_given(motion);
    return least_slowed(motion, family_.support_keys, Slowing::uniform);
  }

  void add_peaks(ClipRetiming& made, std::vector<SegmentPeaks> peaks, const std::vector<std::size_t>& joints) const {
    for (SegmentPeaks& segment : peaks) {
      for (CertifiedPeak& peak : segment) peak.body = joints[peak.body];
      made.peaks.push_back(std::move(segment));
    }
  }

  [[nodiscard]] Warning measured() const {
    return {
        .code = "measured_peaks",
        .message = formatted("clip {}: the peaks of {} are measured at 17 places of each segment, which is no bound",
                             in_quotes(clip_.name), counted(cubics_.size(), "cubic channel")),
        .numbers = {{"channels", static_cast<double>(cubics_.size())}}};
  }

  [[nodiscard]] ClipRetiming finished(ClipRetiming made, const ClipClock& clock) const {
    if (made.slack > promised_slack) made.warnings.push_back(loose_bounds(method_.name, made.slack));
    made.clip = on_clock(clip_, clock);
    return made;
  }

  const Clip& clip_;
  const Method& method_;
  const FamilyInfo& family_;
  const RetimeOptions& options_;
  OpenEndedWork& work_;
  std::vector<LimitedQuantity> quantities_ = quantities_of(options_.limits);
  std::vector<Group> groups_{};
  std::vector<SegmentPeaks> cubics_{};
};

}  // namespace

Expected<void> check_for_clips(const RetimeOptions& options) {
  const auto of_one_track = [](std::string_view option) {
    return bad_option(option, "found a skeleton, wanted the keys of one track");
  };
  if (options.limits.torque) return of_one_track("max_torque");
  if (options.limits.inertia) return of_one_track("inertia");
  if (options.constant_rate) return of_one_track("constant_rate");
  if (options.constant_speed) return of_one_track("constant_speed");
  if (options.insert_keys > 0) return of_one_track("insert_keys");
  return check(options);
}

Expected<ClipRetiming> retime_clip(const Skeleton& skeleton, const Clip& clip, const Method& method,
                                   const RetimeOptions& options, const Progress& progress) {
  const auto family = family_of_method(method);
  if (!family) return tl::unexpected(family.error());
  const auto sound = check_for_clips(options).and_then([&] { return check_clip(skeleton, clip); });
  if (!sound) return tl::unexpected(sound.error());
  OpenEndedWork work(progress, usual_rounds + (options.slowing == Slowing::uniform
                                                   ? 0.0
                                                   : ways_down * curves_for_interval_times((*family)->support_keys)));
  return ClipSlowing(clip, method, **family, options, work).made().map_error([&](Error error) {
    error.message = formatted("clip {}: {}", in_quotes(clip.name), error.message);
    return error;
  });
}

}}  // namespace orispline
