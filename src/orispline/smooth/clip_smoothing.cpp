// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/clip_smoothing.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/smooth/correlated_fit.hpp>
#include <orispline/smooth/joints_together.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

bool rests(const RotationChannel& channel) {
  return std::ranges::all_of(channel.values, [&](const Eigen::Quaterniond& value) {
    return angular_distance(value, channel.values.front()) <= rest_angle;
  });
}
bool rests(const VectorChannel& channel) {
  return std::ranges::all_of(channel.values, [&](const Eigen::Vector3d& value) {
    return (value - channel.values.front()).norm() <= rest_length;
  });
}

bool is_smoothed(const RotationChannel& channel) {
  return channel.interpolation == ChannelInterpolation::linear && channel.size() >= fewest_smoothed_keys &&
         !rests(channel);
}

/// The translation of the same joint that is smoothed with it.
template <class Channels>
auto* translation_beside(Channels& translations, const RotationChannel& rotation) {
  const auto found = std::ranges::find_if(translations, [&](const VectorChannel& channel) {
    return channel.joint == rotation.joint && channel.times == rotation.times &&
           channel.interpolation == ChannelInterpolation::linear && !rests(channel);
  });
  return found == translations.end() ? nullptr : &*found;
}

Expected<Smoothing> smoothed(const RotationChannel& rotation, const VectorChannel* translation,
                             const SmoothOptions& options) {
  KeyframeData data{.times = rotation.times, .orientations = rotation.values};
  if (translation) data.positions = translation->values;
  SmoothOptions suited = options;
  if (suited.noise_time && !check_noise_time(*suited.noise_time, rotation.times)) suited.noise_time.reset();
  return Keyframes::make(std::move(data)).and_then([&](const Keyframes& keys) { return smooth(Track(keys), suited); });
}

/// Its wrong keys get the orientations to which the motion of the others leads.
void bridge(RotationChannel& rotation, const std::vector<bool>& is_wrong, const SmoothOptions& options) {
  RotationChannel good{.joint = rotation.joint};
  for (std::size_t k = 0; k < rotation.size(); ++k)
    if (!is_wrong[k]) good.times.push_back(rotation.times[k]), good.values.push_back(rotation.values[k]);
  const auto curve = smoothed(good, nullptr, options).and_then([](const Smoothing& smoothing) {
    return make_pose_curve(Method(smoothed_method), smoothing.track.keys);
  });
  const ChannelCurve<Eigen::Quaterniond> straight(good);  // where they cannot be smoothed
  for (std::size_t k = 0; k < rotation.size(); ++k)
    if (const double t = rotation.times[k]; is_wrong[k])
      rotation.values[k] = curve ? curve->orientation(t) : straight.at(t);
}

void bridge(Clip& clip, const std::vector<WrongRun>& runs, const SmoothOptions& options) {
  for (RotationChannel& rotation : clip.rotations) {
    std::vector<bool> is_wrong;
    for (const WrongRun& run : runs) {
      if (std::ranges::find(run.joints, rotation.joint) == run.joints.end()) continue;
      is_wrong.resize(rotation.size());
      std::fill_n(is_wrong.begin() + static_cast<std::ptrdiff_t>(run.first), run.count, true);
    }
    if (!is_wrong.empty()) bridge(rotation, is_wrong, options);
  }
}

/// A rotation of a clip, and where it stands there.
struct Piece {
  std::size_t clip, rotation;
  bool is_together = false;  ///< it is smoothed once more with others: its own motion need not adapt
  Expected<Smoothing> found{};
};

/// Error (bad_argument): the time of the noise is too long for all of them.
Expected<void> check_noise_time(double noise_time, std::span<const Clip> clips, const std::vector<Piece>& pieces) {
  Expected<void> checked;
  for (const Piece& piece : pieces)
    if (checked = check_noise_time(noise_time, clips[piece.clip].rotations[piece.rotation].times); checked) break;
  return checked;
}

/// The noise of one tracker [rad], by what its joints tell one by one: the lower quartile, since the motion of some is
/// rougher than the penalty believes, and what it leaves counts as noise. Absent where none could be smoothed.
std::optional<double> shared_noise(const std::vector<Piece>& pieces) {
  std::vector<double> noises;
  for (const Piece& piece : pieces)
    if (piece.found) noises.push_back(piece.found->noise);
  if (noises.empty()) return std::nullopt;
  const auto quartile = noises.begin() + static_cast<std::ptrdiff_t>(noises.size() / 4);
  std::ranges::nth_element(noises, quartile);
  return std::clamp(*quartile, least_noise, largest_noise);
}

/// Pieces of one clip that have the same key times.
using Together = std::vector<Piece*>;

const RotationChannel& rotation_of(std::span<const Clip> clips, const Piece& piece) {
  return clips[piece.clip].rotations[piece.rotation];
}

/// Those that can be smoothed together.
std::vector<Together> pieces_together(std::span<const Clip> clips, std::vector<Piece>& pieces) {
  std::vector<Together> all;
  for (Piece& piece : pieces) {
    const auto& times = rotation_of(clips, piece).times;
    auto those = std::ranges::find_if(all, [&](const Together& other) {
      return other.front()->clip == piece.clip && rotation_of(clips, *other.front()).times == times;
    });
    if (those == all.end()) those = all.insert(all.end(), Together());
    those->push_back(&piece);
  }
  std::erase_if(all, [&](const Together& some) {
    return !can_be_smoothed_together(some.size(), rotation_of(clips, *some.front()).times);
  });
  return all;
}

void smooth_together(std::span<const Clip> clips, const std::vector<Together>& all, const SmoothOptions& options,
                     unsigned threads) {
  parallel_for(all.size(), threads, [&](std::size_t i) {
    std::vector<SmoothedJoint> joints;
    for (Piece* piece : all[i])
      if (const RotationChannel& rotation = rotation_of(clips, *piece); piece->found)
        joints.push_back({&rotation, translation_beside(clips[piece->clip].translations, rotation), &*piece->found});
    smooth_together(joints, options);
  });
}

/// What was found of a joint, and where its rotation changed most.
ClipSmoothing::OfJoint found_of(const RotationChannel& before, Smoothing smoothing) {
  ClipSmoothing::OfJoint found{.joint = before.joint, .smoothing = std::move(smoothing)};
  const auto after = found.smoothing.track.keys.orientations();
  for (std::size_t i = 0; i < before.size(); ++i)
    if (const double change = angular_distance(before.values[i], after[i]); change > found.largest_change)
      found.largest_change = change, found.change_at = before.times[i];
  return found;
}

void take(Clip& clip, std::size_t rotation, const Keyframes& keys) {
  RotationChannel& channel = clip.rotations[rotation];
  if (VectorChannel* const translation = translation_beside(clip.translations, channel))
    translation->values.assign(keys.positions().begin(), keys.positions().end());
  channel.values.assign(keys.orientations().begin(), keys.orientations().end());
}

Expected<std::vector<ClipSmoothing>> with_contacts(const Skeleton& skeleton, std::vector<ClipSmoothing> smoothings,
                                                   const SmoothOptions& options) {
  for (ClipSmoothing& smoothing : smoothings) {
    auto held = held_contacts(skeleton, smoothing.clip, options.keep_contacts);
    if (!held) return tl::unexpected(std::move(held.error()));
    smoothing.clip = std::move(held->clip);
    smoothing.contacts = std::move(held->contacts);
  }
  return smoothings;
}

}  // namespace

Expected<std::vector<ClipSmoothing>> smooth_clips(const Skeleton& skeleton, std::span<const Clip> clips,
                                                  const SmoothOptions& options, unsigned threads) {
  if (options.gyro)
    return bad_option("gyro", "found clips, which have no angular velocities, wanted a recording of a gyro");
  if (options.sigma)
    return bad_option("sigma",
                      "found clips, which have no room for standard deviations, wanted a recording of one track");
  std::vector<Piece> pieces;
  std::vector<ClipSmoothing> smoothings;
  std::vector<Clip> bridged;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (auto sound = check_clip(skeleton, clips[i]); !sound) return tl::unexpected(std::move(sound.error()));
    ClipSmoothing& smoothing = smoothings.emplace_back(ClipSmoothing{.clip = clips[i]});
    if (options.runs) {
      smoothing.runs = wrong_runs(skeleton, clips[i]);
      bridge(smoothing.clip, smoothing.runs, options);
    }
    bridged.push_back(smoothing.clip);
    for (std::size_t k = 0; k < bridged[i].rotations.size(); ++k)
      if (is_smoothed(bridged[i].rotations[k])) pieces.push_back({i, k});
      else ++smoothing.left;
  }
  if (options.noise_time)
    if (auto checked = check_noise_time(*options.noise_time, bridged, pieces); !checked)
      return tl::unexpected(std::move(checked.error()));
  const auto smooth_all = [&](const SmoothOptions& with) {
    parallel_for(pieces.size(), threads, [&](std::size_t i) {
      const Clip& clip = bridged[pieces[i].clip];
      const RotationChannel& rotation = clip.rotations[pieces[i].rotation];
      SmoothOptions suited = with;
      suited.adapt = with.adapt && !pieces[i].is_together;
      pieces[i].found = smoothed(rotation, translation_beside(clip.translations, rotation), suited);
    });
  };
  const auto together = are_smoothed_together(options) ? pieces_together(bridged, pieces) : std::vector<Together>();
  for (const Together& some : together)
    for (Piece* piece : some) piece->is_together = true;
  smooth_all(options);
  if (options.noise_time && !options.noise) {
    SmoothOptions shared = options;
    shared.noise = shared_noise(pieces);
    if (shared.noise) smooth_all(shared);
  }
  smooth_together(bridged, together, options, threads);
  for (Piece& piece : pieces) {
    ClipSmoothing& smoothing = smoothings[piece.clip];
    const std::size_t joint = smoothing.clip.rotations[piece.rotation].joint;
    if (!piece.found) {
      Error error = std::move(piece.found.error());
      error.message = formatted("{}: {}", place_of(skeleton, smoothing.clip, joint), error.message);
      if (error.code != ErrorCode::bad_data) return tl::unexpected(std::move(error));
      smoothing.refused.push_back(std::move(error));
      continue;
    }
    take(smoothing.clip, piece.rotation, piece.found->track.keys);
    smoothing.joints.push_back(found_of(clips[piece.clip].rotations[piece.rotation], *std::move(piece.found)));
  }
  if (options.keep_contacts.empty()) return smoothings;
  return with_contacts(skeleton, std::move(smoothings), options);
}

}}  // namespace orispline
