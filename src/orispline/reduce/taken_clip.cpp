// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/taken_clip.hpp>

#include <algorithm>
#include <functional>
#include <utility>

#include <orispline/base/parallel.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/reduce/channel_motion.hpp>
#include <orispline/reduce/channel_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Of all looks at a clip: so many take 64 MB.
constexpr std::size_t most_looks = std::size_t{1} << 21;

/// The places of the channels that have as many keys after as before.
template <CurvePoint P>
std::vector<std::size_t> same_channels(const std::vector<Channel<P>>& before, const std::vector<Channel<P>>& after) {
  std::vector<std::size_t> same;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool has_its_place = i < after.size() && after[i].joint == before[i].joint;
    const Channel<P>* const now = has_its_place ? &after[i] : channel_of(after, before[i].joint);
    if (now && now->size() == before[i].size() && now->interpolation == before[i].interpolation) same.push_back(i);
  }
  return same;
}

/// The motions, but what the channels themselves say where they are the same.
template <CurvePoint P>
std::vector<ChannelCurve<P>> motions_beside(std::vector<ChannelCurve<P>> motions, const std::vector<Channel<P>>& before,
                                            const std::vector<Channel<P>>& after) {
  for (const std::size_t i : same_channels(before, after)) motions[i] = ChannelCurve<P>(before[i]);
  return motions;
}

template <CurvePoint P>
void find_looks(const ChannelCurve<P>& motion, const Channel<P>& channel, std::vector<P>& looks) {
  for (const double t : with_looks_between(channel.times)) looks.push_back(motion.at(t));
}

}  // namespace

TakenClip::TakenClip(const Skeleton& skeleton, const Clip& before, const ClipReduceOptions& options)
    : clip(before), is_smooth(options.between == BetweenSamples::smooth) {
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

void TakenClip::look(unsigned threads) {
  rotation_looks.resize(clip.rotations.size()), translation_looks.resize(clip.translations.size());
  std::size_t left = most_looks;
  std::vector<std::function<void()>> tasks;
  const auto plan = [&](const auto& channels, const auto& motions, auto& looks) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const std::size_t wanted = channels[i].size() * (looks_between + 1);
      if (channels[i].size() < 2 || wanted > left) continue;
      left -= wanted;
      tasks.emplace_back([&, i] { find_looks(motions[i], channels[i], looks[i]); });
    }
  };
  plan(clip.rotations, rotations, rotation_looks);
  plan(clip.translations, translations, translation_looks);
  parallel_for(tasks.size(), threads, [&](std::size_t i) { tasks[i](); });
}

bool TakenClip::is_beside_as_taken(const Clip& after) const {
  const auto is_stored = [](const auto& channel) {
    return channel.interpolation != ChannelInterpolation::linear || channel.size() < 3;
  };
  return !is_smooth || (std::ranges::all_of(same_channels(clip.rotations, after.rotations),
                                            [&](std::size_t i) { return is_stored(clip.rotations[i]); }) &&
                        std::ranges::all_of(same_channels(clip.translations, after.translations),
                                            [&](std::size_t i) { return is_stored(clip.translations[i]); }));
}

ClipMotion TakenClip::beside(const Skeleton& skeleton, const Clip& after) const {
  return {skeleton, motions_beside(rotations, clip.rotations, after.rotations),
          motions_beside(translations, clip.translations, after.translations), scales};
}

}}  // namespace orispline
