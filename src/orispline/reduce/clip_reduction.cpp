// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/clip_reduction.hpp>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/clip/single_precision.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce/channel_motion.hpp>
#include <orispline/reduce/channel_reduction.hpp>
#include <orispline/reduce/clip_bytes.hpp>
#include <orispline/reduce/cuts.hpp>
#include <orispline/reduce/few_times.hpp>
#include <orispline/reduce/hermite_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Clip as_stored(Clip clip, const ClipReduceOptions& options) {
  if (options.precision == options.precision_before || options.precision == KeyPrecision::float64) return clip;
  const auto store = [](auto& channels) {
    for (auto& channel : channels)
      if (channel.interpolation != ChannelInterpolation::step) channel = in_single_precision(channel);
  };
  store(clip.rotations), store(clip.translations), store(clip.scales);
  return clip;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int rounds_in_world = 6;
constexpr double first_factor = 0.6;
constexpr double widest_angle = std::numbers::pi * (1.0 + 1e-12);  // [rad], and the rounding of degrees
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

/// A clip, and the motion that it is taken to be.
struct TakenClip {
  Clip clip;                                                        ///< with short cuts
  std::size_t cuts = 0;                                             ///< in the clip
  std::vector<std::vector<Cut>> of_rotations{}, of_translations{};  ///< of every channel
  std::vector<ChannelCurve<Eigen::Quaterniond>> rotations{};
  std::vector<ChannelCurve<Eigen::Vector3d>> translations{}, scales{};
  std::vector<double> times{};  ///< of its keys, and those between at which it is looked at

  TakenClip(const Skeleton& skeleton, const Clip& before, const ClipReduceOptions& options) : clip(before) {
    if (options.cuts != Cuts::none) {
      const bool with_steps = options.cuts == Cuts::steps || options.between == BetweenSamples::smooth;
      auto cuts_of_joints = cuts_of(skeleton, clip, with_steps ? CutSearch::single_steps : CutSearch::close_keys);
      cuts = count_of(cuts_of_joints);
      if (cuts > 0) clip = with_short_cuts(std::move(clip), cuts_of_joints);
      for (const RotationChannel& channel : clip.rotations)
        of_rotations.push_back(cuts_in(channel, cuts_of_joints[channel.joint]));
      for (const VectorChannel& channel : clip.translations)
        of_translations.push_back(cuts_in(channel, cuts_of_joints[channel.joint]));
    }
    of_rotations.resize(clip.rotations.size()), of_translations.resize(clip.translations.size());
    for (std::size_t i = 0; i < clip.rotations.size(); ++i)
      rotations.push_back(motion_between(clip.rotations[i], options.between, of_rotations[i]));
    for (std::size_t i = 0; i < clip.translations.size(); ++i)
      translations.push_back(motion_between(clip.translations[i], options.between, of_translations[i]));
    for (const VectorChannel& channel : clip.scales) scales.emplace_back(channel);
    times = with_looks_between(key_times(clip));
  }

  /// What the clip with fewer keys is measured against: channels that are the same are no distance off.
  [[nodiscard]] ClipMotion beside(const Skeleton& skeleton, const Clip& after) const {
    const auto taken = []<CurvePoint P>(std::vector<ChannelCurve<P>> motions, const std::vector<Channel<P>>& before,
                                        const std::vector<Channel<P>>& fewer) {
      for (std::size_t i = 0; i < motions.size(); ++i)
        if (fewer[i].size() == before[i].size() && fewer[i].interpolation == before[i].interpolation)
          motions[i] = ChannelCurve<P>(before[i]);
      return motions;
    };
    return {skeleton, taken(rotations, clip.rotations, after.rotations),
            taken(translations, clip.translations, after.translations), scales};
  }
};

/// A clip on its way to fewer keys.
struct ClipWork {
  const TakenClip* before;
  double factor = first_factor, too_large = infinity;  ///< of the tolerances in the world
  bool is_done = false;
  std::optional<ClipReduction> best{};
};

/// A channel of a clip.
struct Piece {
  std::size_t work, list, channel;  ///< list: 0 rotations, 1 translations
};

class ClipReducer {
 public:
  ClipReducer(const Skeleton& skeleton, const ClipReduceOptions& options, unsigned threads)
      : skeleton_(skeleton),
        options_(options),
        threads_(threads),
        world_(skeleton, options.world_tolerance, options.shell) {}

  Expected<std::vector<ClipReduction>> reduced(std::span<const Clip> clips) {
    std::vector<std::optional<TakenClip>> taken(clips.size());
    parallel_for(clips.size(), threads_, [&](std::size_t i) { taken[i].emplace(skeleton_, clips[i], options_); });
    std::vector<ClipWork> works;
    for (const auto& clip : taken) works.push_back({.before = &*clip});
    for (int round = 0; round < (in_world() ? rounds_in_world : 1); ++round)
      if (auto went = try_all(works); !went) return tl::unexpected(std::move(went.error()));
    std::vector<ClipReduction> reductions;
    for (std::size_t i = 0; i < works.size(); ++i)
      reductions.push_back(works[i].best ? *std::move(works[i].best) : measured(*works[i].before, clips[i]));
    parallel_for(works.size(), threads_, [&](std::size_t i) { complete(reductions[i], clips[i], *works[i].before); });
    return reductions;
  }

 private:
  [[nodiscard]] bool in_world() const { return options_.world_tolerance < infinity; }

  /// All clips that are not done yet, with their present factors.
  Expected<void> try_all(std::vector<ClipWork>& works) const {
    std::vector<Clip> after;
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < works.size(); ++i) {
      after.push_back(works[i].is_done ? Clip() : resting_once(works[i].before->clip, works[i].factor));
      for (std::size_t k = 0; k < after[i].rotations.size(); ++k) pieces.push_back({i, 0, k});
      for (std::size_t k = 0; k < after[i].translations.size(); ++k) pieces.push_back({i, 1, k});
    }
    std::vector<std::optional<Error>> errors(pieces.size());
    parallel_for(pieces.size(), threads_, [&](std::size_t i) {
      const ClipWork& work = works[pieces[i].work];
      errors[i] = reduce(*work.before, after[pieces[i].work], pieces[i], work.factor);
    });
    for (auto& error : errors)
      if (error) return tl::unexpected(*std::move(error));
    parallel_for(works.size(), threads_, [&](std::size_t i) {
      if (works[i].is_done) return;
      if (seeks_bytes()) after[i] = with_shared_keys(*works[i].before, works[i].factor, std::move(after[i]));
      judge(works[i], std::move(after[i]));
    });
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

  [[nodiscard]] Clip with_shared_keys(const TakenClip& before, double factor, Clip after) const {
    if (options_.compression == KeyCompression::none) return with_shared_times(before.clip, std::move(after));
    return with_few_times(before, factor, std::move(after));
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
  [[nodiscard]] Clip with_few_times(const TakenClip& before, double factor, Clip after) const {
    std::map<std::vector<double>, SharingTimes> groups;
    const auto gather = [&](const auto& channels, const auto& motions, const auto& cuts, auto& places, auto list,
                            auto&& tolerance_of) {
      for (std::size_t i = 0; i < channels.size(); ++i) {
        const double tolerance = tolerance_of(channels[i].joint, factor);
        const bool may_share = channels[i].interpolation == ChannelInterpolation::linear && channels[i].size() > 2 &&
                               places[i].size() > 2 && cuts[i].empty() && tolerance < infinity;
        if (!may_share) continue;
        (groups[channels[i].times].*list)
            .push_back({rounded_channel(channels[i], tolerance, options_), &motions[i], &places[i], tolerance});
      }
    };
    gather(before.clip.rotations, before.rotations, before.of_rotations, after.rotations, &SharingTimes::rotations,
           [this](std::size_t joint, double scaled) {
             return std::min(angle_tolerance(joint, scaled), std::numbers::pi / 2);
           });
    gather(before.clip.translations, before.translations, before.of_translations, after.translations,
           &SharingTimes::translations,
           [this](std::size_t joint, double scaled) { return length_tolerance(joint, scaled); });
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
            farthest_from(*one.motion, fewer, one.rounded.times).value <= one.tolerance)
          *one.place = fewer;
      }
    };
    take(group.rotations), take(group.translations);
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

  std::optional<Error> reduce(const TakenClip& before, Clip& clip, const Piece& piece, double factor) const {
    const std::size_t i = piece.channel;
    if (piece.list == 0) {
      RotationChannel& channel = clip.rotations[i];
      const double tolerance = angle_tolerance(channel.joint, factor);
      return reduce(clip, channel, before.rotations[i], before.of_rotations[i],
                    tolerance < infinity ? std::min(tolerance, std::numbers::pi / 2) : tolerance);
    }
    VectorChannel& channel = clip.translations[i];
    return reduce(clip, channel, before.translations[i], before.of_translations[i],
                  length_tolerance(channel.joint, factor));
  }

  /// Of a joint's rotation and of its translation, both in the frame of its parent; infinite where nothing bounds them.
  [[nodiscard]] double angle_tolerance(std::size_t joint, double factor) const {
    return std::min(options_.tolerance, factor * world_.angles[joint]);
  }
  [[nodiscard]] double length_tolerance(std::size_t joint, double factor) const {
    return std::min(options_.position_tolerance, factor * world_.lengths[joint]);
  }

  template <CurvePoint P>
  std::optional<Error> reduce(const Clip& clip, Channel<P>& channel, const ChannelCurve<P>& motion,
                              const std::vector<Cut>& cuts, double tolerance) const {
    if (!(tolerance < infinity)) return std::nullopt;
    auto reduced = reduced_channel<P>({channel, motion, cuts}, tolerance, options_);
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
  void judge(ClipWork& work, Clip after) const {
    ClipReduction reduction = measured(*work.before, std::move(after));
    const double length = options_.world_tolerance, found = reduction.distance.largest.value;
    if (!in_world() || (found <= length && found >= near_enough * length)) work.is_done = true;
    if (found > length) work.too_large = std::min(work.too_large, work.factor);
    else if (!work.best || cost_of(reduction) <= cost_of(*work.best)) work.best = std::move(reduction);
    if (work.is_done) return;
    const double wanted = 0.96 * length / std::max(found, 1e-3 * length);
    const double next = work.factor * std::min(wanted, 4.0);
    work.is_done = next >= work.too_large * 0.98 && found <= length;
    work.factor = next;
  }

  /// With the keys of tracks and the distances from the motion before.
  [[nodiscard]] ClipReduction measured(const TakenClip& taken, Clip clip) const {
    const Clip& before = taken.clip;
    const Clip after = as_stored(clip, options_);
    ClipReduction reduction{.cuts = taken.cuts};
    std::vector<JointDifference> found(skeleton_.size());
    if (!taken.times.empty()) {
      std::vector<std::size_t> same(skeleton_.size());
      std::iota(same.begin(), same.end(), std::size_t{0});
      found = differences(taken.beside(skeleton_, after), ClipMotion(skeleton_, after), same, taken.times,
                          options_.shell, Between::looked_at_for_largest);
      for (std::size_t i = 0; i < found.size(); ++i) reduction.distance.take(found[i].distance, i);
    }
    for (std::size_t i = 0; i < before.rotations.size(); ++i) {
      const RotationChannel& channel = before.rotations[i];
      if (channel.interpolation != ChannelInterpolation::step)
        reduction.angle.take(found[channel.joint].angle, channel.joint);
      if (channel.size() >= 3) reduction.rotation_keys += after.rotations[i].size();
    }
    for (std::size_t i = 0; i < before.translations.size(); ++i) {
      const VectorChannel& channel = before.translations[i];
      reduction.translation_keys += after.translations[i].size();
      if (channel.interpolation != ChannelInterpolation::step)
        reduction.translation.take(found[channel.joint].translation, channel.joint);
    }
    reduction.clip = std::move(clip);
    return reduction;
  }

  /// With what is told of the clip that was chosen.
  void complete(ClipReduction& reduction, const Clip& given, const TakenClip& taken) const {
    const Clip after = as_stored(reduction.clip, options_);
    for (std::size_t i = 0; i < given.rotations.size(); ++i) {
      const RotationChannel &channel = given.rotations[i], &fewer = after.rotations[i];
      if (channel.size() < 3) continue;
      ++reduction.rotation_tracks;
      reduction.rotation_keys_before += channel.size();
      if (!ends_as_it_begins(fewer)) {
        ++reduction.open_tracks;
        reduction.open.push_back({channel.joint, true, apart_at_ends(fewer)});
      }
      const auto other = options_.between == BetweenSamples::smooth ? BetweenSamples::stored : BetweenSamples::smooth;
      (other == BetweenSamples::smooth ? reduction.from_smooth : reduction.from_stored)
          .take(farthest_from(motion_between(taken.clip.rotations[i], other, taken.of_rotations[i]), fewer,
                              taken.clip.rotations[i].times),
                channel.joint);
    }
    if (reduction.rotation_tracks > 0)
      (options_.between == BetweenSamples::smooth ? reduction.from_smooth : reduction.from_stored) = reduction.angle;
    for (std::size_t i = 0; i < given.translations.size(); ++i) {
      const VectorChannel &channel = given.translations[i], &fewer = after.translations[i];
      reduction.translation_keys_before += channel.size();
      if (channel.size() >= 3 && !ends_as_it_begins(fewer))
        reduction.open.push_back({channel.joint, false, apart_at_ends(fewer)});
    }
  }

  const Skeleton& skeleton_;
  const ClipReduceOptions& options_;
  unsigned threads_;
  WorldTolerances world_;
};

}  // namespace

Expected<void> check(const ClipReduceOptions& options) {
  for (const double tolerance : {options.tolerance, options.position_tolerance, options.world_tolerance, options.shell})
    if (!(tolerance > 0.0))
      return failure(ErrorCode::bad_argument,
                     formatted("found a tolerance of {}, wanted one greater than 0", tolerance));
  if (options.tolerance < infinity && options.tolerance > widest_angle)
    return bad_option("tolerance",
                      formatted("found {:.6g}°, wanted 180° at most, which is as far as rotations can be apart",
                                options.tolerance * degrees));
  if (auto known = check(options.compression); !known) return known;
  if (options.next_tool == NextTool::meshopt && options.method.name != "slerp" &&
      options.method.name != smallest_method)
    return bad_option("for",
                      formatted("found the method {}, whose splines of rotations gltf-transform's meshopt breaks, "
                                "wanted slerp or {}",
                                text_of(options.method), smallest_method));
  if (options.closed && options.method.name != cubicspline_method && !seeks_rates(options.method))
    return bad_option("closed",
                      formatted("found the method {}, wanted {}, or {} in its form chart: their tangents are free",
                                text_of(options.method), cubicspline_method, "hermite-c1"));
  return {};
}

Expected<std::vector<ClipReduction>> reduce_clips(const Skeleton& skeleton, std::span<const Clip> clips,
                                                  const ClipReduceOptions& options, unsigned threads) {
  if (auto sound = check(options); !sound) return tl::unexpected(std::move(sound.error()));
  for (const Clip& clip : clips)
    if (auto sound = check_clip(skeleton, clip); !sound) return tl::unexpected(std::move(sound.error()));
  return ClipReducer(skeleton, options, threads).reduced(clips);
}

}}  // namespace orispline
