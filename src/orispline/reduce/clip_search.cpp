// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/clip_search.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/reduce/channel_motion.hpp>
#include <orispline/reduce/channel_reduction.hpp>
#include <orispline/reduce/clip_bytes.hpp>
#include <orispline/reduce/few_times.hpp>
#include <orispline/reduce/rest.hpp>
#include <orispline/reduce/taken_clip.hpp>
#include <orispline/reduce/world_distances.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int rounds_in_world = 6;
constexpr double first_factor = 0.6;
/// A clip that uses so much of its length is not tried with wider tolerances.
constexpr double near_enough = 0.9;

/// The tolerances of the joints for a length in the world, before they are scaled.
struct WorldTolerances {
  std::vector<double> angles;   ///< [rad]
  std::vector<double> lengths;  ///< in the frame of the joint's parent

  WorldTolerances(const Skeleton& skeleton, double length, double shell) {
    const Clip rest;
    const std::vector<Eigen::Affine3d> poses = world_poses(skeleton, rest, std::array{0.0});
    std::vector<double> chains(skeleton.size(), 0.0);
    for (std::size_t i = skeleton.size(); i-- > 0;) {
      const std::size_t parent = skeleton[i].parent;
      if (parent != no_parent)
        chains[parent] =
            std::max(chains[parent], chains[i] + (poses[i].translation() - poses[parent].translation()).norm());
    }
    for (std::size_t i = 0; i < skeleton.size(); ++i) {
      const std::size_t parent = skeleton[i].parent;
      const double stretch = parent == no_parent ? 1.0 : poses[parent].linear().colwise().norm().maxCoeff();
      angles.push_back(length / (chains[i] + shell));
      lengths.push_back(length / std::max(stretch, 1e-12));
    }
  }
};

/// How many times longer in the world a length in the frame of each joint's parent may be, at most.
std::vector<double> stretches_of(const Skeleton& skeleton, const Clip& clip) {
  const auto largest = [](const Eigen::Vector3d& scale) { return scale.cwiseAbs().maxCoeff(); };
  std::vector<double> own, above(skeleton.size(), 1.0);
  for (const Joint& joint : skeleton.joints()) own.push_back(largest(joint.rest.scale));
  for (const VectorChannel& channel : clip.scales)
    own[channel.joint] = largest(std::ranges::max(channel.values, {}, largest));
  for (std::size_t i = 0; i < skeleton.size(); ++i)
    if (const std::size_t parent = skeleton[i].parent; parent != no_parent) above[i] = above[parent] * own[parent];
  return above;
}

/// The search for the fewest keys of one clip.
class ClipSearch {
 public:
  ClipSearch(const Skeleton& skeleton, const Clip& given, const ClipReduceOptions& options, unsigned threads)
      : skeleton_(skeleton),
        given_(given),
        options_(options),
        threads_(threads),
        world_(skeleton, options.world_tolerance, options.shell),
        before_(looked_at(TakenClip(skeleton, given, options), threads)),
        distances_(skeleton, before_, options.shell, in_world()) {}

  Expected<ClipReduction> found() {
    for (int round = 0; round < (in_world() ? rounds_in_world : 1) && !is_done_; ++round)
      if (auto tried = attempt(); !tried) return tl::unexpected(std::move(tried.error()));
    ClipReduction reduction = best_ ? *std::move(best_) : measured(given_);
    complete(reduction);
    return reduction;
  }

 private:
  static TakenClip looked_at(TakenClip taken, unsigned threads) {
    taken.look(threads);
    return taken;
  }

  [[nodiscard]] bool in_world() const { return options_.world_tolerance < infinity; }

  /// The clip with the present factor.
  Expected<void> attempt() {
    Clip after = resting_once(before_.clip, factor_);
    const std::size_t rotations = after.rotations.size();
    std::vector<std::optional<Error>> errors(rotations + after.translations.size());
    parallel_for(errors.size(), threads_, [&](std::size_t i) {
      errors[i] = i < rotations ? reduce_rotation(after, i) : reduce_translation(after, i - rotations);
    });
    for (auto& error : errors)
      if (error) return tl::unexpected(*std::move(error));
    if (seeks_bytes()) after = with_shared_keys(std::move(after));
    judge(std::move(after));
    return {};
  }

  /// The clip with one key in the place of those that are the same but for rounding, and within the tolerances. It
  /// lasts as long as before: if need be one channel keeps the same key at its end.
  [[nodiscard]] Clip resting_once(const Clip& before, double factor) const {
    Clip clip = before;
    const std::vector<double> stretches = stretches_of(skeleton_, before);
    for (RotationChannel& channel : clip.rotations)
      channel = resting_channel(channel, skeleton_[channel.joint].rest.rotation,
                                std::min(rest_angle, angle_tolerance(channel.joint, factor)), options_.precision);
    for (VectorChannel& channel : clip.translations) {
      const double rounding = rest_length / std::max(stretches[channel.joint], 1.0);
      channel = resting_channel(channel, skeleton_[channel.joint].rest.translation,
                                std::min(rounding, length_tolerance(channel.joint, factor)), options_.precision);
    }
    for (VectorChannel& channel : clip.scales) {
      // By a part of its size a scale moves points as far as a turn by so many radians does.
      const double size = channel.values.front().cwiseAbs().maxCoeff();
      channel =
          resting_channel(channel, skeleton_[channel.joint].rest.scale,
                          size * std::min(rest_length, factor * world_.angles[channel.joint]), options_.precision);
    }
    const double end = before.domain().end;
    if (clip.domain().end < end)
      held_to(end, before.rotations, clip.rotations) || held_to(end, before.translations, clip.translations) ||
          held_to(end, before.scales, clip.scales);
    return clip;
  }

  [[nodiscard]] Clip with_shared_keys(Clip after) const {
    if (options_.compression == KeyCompression::none) return with_shared_times(before_.clip, std::move(after));
    return with_few_times(std::move(after));
  }

  /// A channel that may share its times with others.
  template <CurvePoint P>
  struct Sharing {
    Channel<P> rounded{};
    const ChannelCurve<P>* motion = nullptr;
    Channel<P>* place = nullptr;
    double tolerance = 0.0;
  };
  /// Those that had the same times.
  struct SharingTimes {
    std::vector<Sharing<Eigen::Quaterniond>> rotations{};
    std::vector<Sharing<Eigen::Vector3d>> translations{};
  };

  /// The clip with linear channels in the place of those that then take fewer bytes, because they share their times.
  [[nodiscard]] Clip with_few_times(Clip after) const {
    std::map<std::vector<double>, SharingTimes> groups;
    const auto gather = [&](const auto& channels, const auto& motions, const auto& cuts, auto& places, auto list,
                            auto&& tolerance_of) {
      for (std::size_t i = 0; i < channels.size(); ++i) {
        const double tolerance = tolerance_of(channels[i].joint);
        const bool may_share = channels[i].interpolation == ChannelInterpolation::linear && channels[i].size() > 2 &&
                               places[i].size() > 2 && cuts[i].empty() && tolerance < infinity;
        if (!may_share) continue;
        (groups[channels[i].times].*list)
            .push_back({rounded_channel(channels[i], tolerance, options_), &motions[i], &places[i], tolerance});
      }
    };
    gather(before_.clip.rotations, before_.rotations, before_.of_rotations, after.rotations, &SharingTimes::rotations,
           [this](std::size_t joint) { return std::min(angle_tolerance(joint, factor_), std::numbers::pi / 2); });
    gather(before_.clip.translations, before_.translations, before_.of_translations, after.translations,
           &SharingTimes::translations, [this](std::size_t joint) { return length_tolerance(joint, factor_); });
    for (auto& [times, group] : groups) share_times(group);
    return after;
  }

  void share_times(SharingTimes& group) const {
    std::vector<KeyReach> reaches;
    const auto look = [&](const auto& list) {
      for (const auto& one : list) reaches.push_back(reach_of(one.rounded, *one.motion, one.tolerance));
    };
    look(group.rotations), look(group.translations);
    const auto keys = keys_at_few_times(reaches);
    std::size_t next = 0;
    const auto take = [&](auto& list) {
      for (auto& one : list) {
        const auto fewer = only_keys(one.rounded, keys[next++]);
        // What it takes by itself, with times of its own: those of others it has for nothing.
        if (bytes_of_values(fewer, options_.compression) < bytes_of_keys(*one.place, options_.compression) &&
            farthest_of(one, fewer) <= one.tolerance)
          *one.place = fewer;
      }
    };
    take(group.rotations), take(group.translations);
  }

  template <CurvePoint P>
  static double farthest_of(const Sharing<P>& one, const Channel<P>& fewer) {
    return farthest_from<P>(*one.motion, fewer, one.rounded.times).value;
  }

  template <CurvePoint P>
  static Channel<P> only_keys(const Channel<P>& channel, const std::vector<std::size_t>& keys) {
    Channel<P> fewer{.joint = channel.joint, .interpolation = channel.interpolation};
    for (const std::size_t k : keys) {
      fewer.times.push_back(channel.times[k]);
      fewer.values.push_back(channel.values[k]);
    }
    return fewer;
  }

  /// Gives the first channel that ended there its last key again; whether there was one.
  template <CurvePoint P>
  static bool held_to(double end, const std::vector<Channel<P>>& before, std::vector<Channel<P>>& after) {
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].times.back() < end) continue;
      after[i].times.push_back(end);
      after[i].values.push_back(after[i].values.front());
      return true;
    }
    return false;
  }

  std::optional<Error> reduce_rotation(Clip& clip, std::size_t i) const {
    RotationChannel& channel = clip.rotations[i];
    const double tolerance = angle_tolerance(channel.joint, factor_);
    return reduce<Eigen::Quaterniond>(
        clip, channel, skeleton_[channel.joint].rest.rotation,
        {channel, before_.rotations[i], before_.of_rotations[i], before_.rotation_looks[i]},
        tolerance < infinity ? std::min(tolerance, std::numbers::pi / 2) : tolerance);
  }
  std::optional<Error> reduce_translation(Clip& clip, std::size_t i) const {
    VectorChannel& channel = clip.translations[i];
    return reduce<Eigen::Vector3d>(
        clip, channel, skeleton_[channel.joint].rest.translation,
        {channel, before_.translations[i], before_.of_translations[i], before_.translation_looks[i]},
        length_tolerance(channel.joint, factor_));
  }

  /// Of a joint's rotation and of its translation, both in the frame of its parent; infinite where nothing bounds them.
  [[nodiscard]] double angle_tolerance(std::size_t joint, double factor) const {
    return std::min(options_.tolerance, factor * world_.angles[joint]);
  }
  [[nodiscard]] double length_tolerance(std::size_t joint, double factor) const {
    return std::min(options_.position_tolerance, factor * world_.lengths[joint]);
  }

  template <CurvePoint P>
  std::optional<Error> reduce(const Clip& clip, Channel<P>& channel, const P& rest, const TakenChannel<P>& taken,
                              double tolerance) const {
    if (!(tolerance < infinity) || is_rest(channel, rest)) return std::nullopt;
    auto reduced = reduced_channel<P>(taken, tolerance, options_);
    if (!reduced) {
      reduced.error().message = formatted("{}: {}", place_of(skeleton_, clip, channel.joint), reduced.error().message);
      return std::move(reduced.error());
    }
    channel = *std::move(reduced);
    return std::nullopt;
  }

  [[nodiscard]] bool seeks_bytes() const { return options_.method.name == smallest_method; }
  /// What is to be least.
  [[nodiscard]] std::size_t cost_of(const ClipReduction& reduction) const {
    return seeks_bytes() ? bytes_of_keys(reduction.clip, options_.compression)
                         : reduction.rotation_keys + reduction.translation_keys;
  }

  /// Keeps what is within the length in the world, and chooses the next factor.
  void judge(Clip after) {
    ClipReduction reduction = measured(std::move(after));
    const double length = options_.world_tolerance, found = reduction.distance.largest.value;
    if (!in_world() || (found <= length && found >= near_enough * length)) is_done_ = true;
    if (found > length) too_large_ = std::min(too_large_, factor_);
    else if (!best_ || cost_of(reduction) <= cost_of(*best_)) best_ = std::move(reduction);
    if (is_done_) return;
    const double wanted = 0.96 * length / std::max(found, 1e-3 * length);
    const double next = factor_ * std::min(wanted, 4.0);
    is_done_ = next >= too_large_ * 0.98 && found <= length;
    factor_ = next;
  }

  /// With its keys, and its distance in the world from the motion before.
  [[nodiscard]] ClipReduction measured(Clip clip) {
    ClipReduction reduction{.cuts = before_.cuts};
    if (!before_.times.empty()) reduction.distance = distances_.farthest(as_stored(clip, options_));
    for (std::size_t i = 0; i < before_.clip.rotations.size(); ++i)
      if (before_.clip.rotations[i].size() >= 3) reduction.rotation_keys += clip.rotations[i].size();
    for (const VectorChannel& channel : clip.translations) reduction.translation_keys += channel.size();
    reduction.clip = std::move(clip);
    return reduction;
  }

  /// With what is told of the clip that was chosen.
  void complete(ClipReduction& reduction) const {
    const Clip after = as_stored(reduction.clip, options_);
    const bool is_smooth = options_.between == BetweenSamples::smooth;
    const auto other = is_smooth ? BetweenSamples::stored : BetweenSamples::smooth;
    ClipReduction::Worst& from_other = is_smooth ? reduction.from_stored : reduction.from_smooth;
    ClipReduction::Worst& from_taken = is_smooth ? reduction.from_smooth : reduction.from_stored;
    for (std::size_t i = 0; i < given_.rotations.size(); ++i) {
      const RotationChannel &channel = before_.clip.rotations[i], &fewer = after.rotations[i];
      take_farthest(reduction.angle, before_.rotations[i], channel, fewer, before_.rotation_looks[i]);
      if (given_.rotations[i].size() < 3) continue;
      ++reduction.rotation_tracks;
      reduction.rotation_keys_before += given_.rotations[i].size();
      if (note_open(reduction, channel, fewer, before_.of_rotations[i], true)) ++reduction.open_tracks;
      const auto motion = motion_between(channel, other, before_.of_rotations[i]);
      from_other.take(farthest_from<Eigen::Quaterniond>(motion, fewer, channel.times, {}, from_other.largest.value),
                      channel.joint);
    }
    if (reduction.rotation_tracks > 0) from_taken = reduction.angle;
    for (std::size_t i = 0; i < given_.translations.size(); ++i) {
      const VectorChannel &channel = before_.clip.translations[i], &fewer = after.translations[i];
      take_farthest(reduction.translation, before_.translations[i], channel, fewer, before_.translation_looks[i]);
      reduction.translation_keys_before += given_.translations[i].size();
      if (given_.translations[i].size() >= 3) note_open(reduction, channel, fewer, before_.of_translations[i], false);
    }
    reduction.tracks_before = given_.rotations.size() + given_.translations.size() + given_.scales.size();
    if (!options_.keep_constant) leave_out_resting(reduction);
  }

  /// How far a channel is off, unless it is one of steps.
  template <CurvePoint P>
  void take_farthest(ClipReduction::Worst& worst, const ChannelCurve<P>& motion, const Channel<P>& channel,
                     const Channel<P>& fewer, const std::vector<P>& looks) const {
    if (channel.interpolation == ChannelInterpolation::step) return;
    const bool is_same = fewer.size() == channel.size() && fewer.interpolation == channel.interpolation;
    worst.take(is_same ? farthest_from<P>(ChannelCurve<P>(channel), fewer, channel.times, {}, worst.largest.value)
                       : farthest_from<P>(motion, fewer, channel.times, looks, worst.largest.value),
               channel.joint);
  }

  /// Whether a channel is open where the clip begins again.
  template <CurvePoint P>
  bool note_open(ClipReduction& reduction, const Channel<P>& channel, const Channel<P>& fewer,
                 const std::vector<Cut>& cuts, bool is_rotation) const {
    const bool is_cut = options_.closed && is_cut_at_ends(channel, cuts), is_open = is_cut || !ends_as_it_begins(fewer);
    if (is_open) reduction.open.push_back({channel.joint, is_rotation, apart_at_ends(fewer), is_cut});
    return is_open;
  }

  void leave_out_resting(ClipReduction& reduction) const {
    const auto keys_of_turns = [&] {
      std::size_t keys = 0;
      for (const RotationChannel& before : given_.rotations)
        if (const auto* after = channel_of(reduction.clip.rotations, before.joint); after && before.size() >= 3)
          keys += after->size();
      return keys;
    };
    const RidOfRest gone = take_out_resting(skeleton_, reduction.clip);
    reduction.tracks_left_out = gone.all();
    reduction.rotation_keys = keys_of_turns();
    reduction.translation_keys -= gone.translations;
  }

  const Skeleton& skeleton_;
  const Clip& given_;
  const ClipReduceOptions& options_;
  unsigned threads_;
  WorldTolerances world_;
  TakenClip before_;
  WorldDistances distances_;
  double factor_ = first_factor, too_large_ = infinity;  ///< of the tolerances in the world
  bool is_done_ = false;
  std::optional<ClipReduction> best_{};
};

}  // namespace

Expected<ClipReduction> clip_with_fewest_keys(const Skeleton& skeleton, const Clip& clip,
                                              const ClipReduceOptions& options, unsigned threads) {
  return ClipSearch(skeleton, clip, options, threads).found();
}

}}  // namespace orispline
