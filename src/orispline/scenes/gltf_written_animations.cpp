// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_written_animations.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/gltf_written_channel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

using Place = std::pair<std::size_t, Property>;  ///< a node, and what of it moves

/// The channels of the animation that a clip takes the place of.
struct OldAnimation {
  Json json = Json::object();
  std::string name{};
  std::vector<AnimationChannel> channels{};
  std::map<Place, std::size_t> sampler_of{};
};

Expected<OldAnimation> old_animation(const Document& document, std::optional<std::size_t> index) {
  if (!index) return OldAnimation{};
  const auto object = animation_of(document, *index);
  if (!object) return tl::unexpected(object.error());
  auto name = animation_name(*object, *index);
  if (!name) return tl::unexpected(std::move(name.error()));
  return animation_channels(document, *object).map([&](std::vector<AnimationChannel> channels) {
    OldAnimation old{document.json["animations"][*index], std::move(*name), std::move(channels), {}};
    for (const AnimationChannel& channel : old.channels)
      if (channel.target)
        old.sampler_of.emplace(Place(channel.target->node, channel.target->property), channel.sampler);
    return old;
  });
}

std::string_view word_of(ChannelInterpolation interpolation) {
  return interpolation == ChannelInterpolation::step ? "STEP" : "CUBICSPLINE";
}

/// One key less may shorten the clip: then one channel that does not move keeps its last.
std::vector<WrittenChannel> with_end(std::vector<WrittenChannel> channels) {
  const auto last = [](const WrittenChannel& channel) { return channel.times.back(); };
  if (channels.empty()) return channels;
  const auto longest = std::ranges::max_element(channels, {}, &WrittenChannel::end);
  if (std::ranges::max(channels, {}, last).times.back() < longest->end) *longest = held_to_end(std::move(*longest));
  return channels;
}

/// Channels and samplers of an animation, made one by one; equal samplers are one.
class SamplerList {
 public:
  /// A sampler that stays as it was.
  [[nodiscard]] std::size_t kept(std::size_t old, const Json& samplers) {
    const auto [found, is_new] = of_old_.try_emplace(old, list_.size());
    if (is_new) list_.push_back(samplers[old]);
    return found->second;
  }
  [[nodiscard]] std::size_t made(std::size_t input, std::size_t output, ChannelInterpolation interpolation) {
    const auto [found, is_new] = of_keys_.try_emplace({input, output, interpolation}, list_.size());
    if (!is_new) return found->second;
    Json sampler{{"input", input}, {"output", output}};
    if (interpolation != ChannelInterpolation::linear) sampler["interpolation"] = word_of(interpolation);
    list_.push_back(std::move(sampler));
    return found->second;
  }
  [[nodiscard]] Json list() && { return std::move(list_); }

 private:
  Json list_ = Json::array();
  std::map<std::size_t, std::size_t> of_old_{};
  std::map<std::tuple<std::size_t, std::size_t, ChannelInterpolation>, std::size_t> of_keys_{};
};

class Writer {
 public:
  Writer(const Scene& scene, const Source& source, KeyStore store)
      : scene_(scene), source_(source), result_{.store = std::move(store)} {}

  [[nodiscard]] Expected<WrittenAnimations> all(const AnimationPlan& plan) && {
    for (std::size_t i = 0; i < scene_.clips.size(); ++i) {
      const auto old = old_animation(source_.document(), plan.of_clip[i]);
      if (!old) return tl::unexpected(old.error());
      auto channels = channels_of(scene_.clips[i], *old);
      if (!channels) return tl::unexpected(std::move(channels.error()));
      append(scene_.clips[i], *old, with_end(std::move(*channels)));
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Expected<std::vector<WrittenChannel>> channels_of(const Clip& clip, const OldAnimation& old) {
    std::vector<WrittenChannel> channels;
    const auto append_to = [&](const auto& list, auto&& write) -> Expected<void> {
      for (const auto& channel : list) {
        auto done = write(channel);
        const std::string place = place_of(scene_.skeleton, clip, channel.joint);
        if (!done) return tl::unexpected(within(place, std::move(done.error())));
        channels.push_back(std::move(*done));
      }
      return {};
    };
    const auto vectors = [](Property property) {
      return [property](const VectorChannel& channel) { return written(channel, property); };
    };
    return append_to(clip.rotations, [&](const RotationChannel& channel) { return written_rotation(channel, old); })
        .and_then([&] { return append_to(clip.translations, vectors(Property::translation)); })
        .and_then([&] { return append_to(clip.scales, vectors(Property::scale)); })
        .map([&] { return std::move(channels); });
  }

  [[nodiscard]] Expected<WrittenChannel> written_rotation(const RotationChannel& channel, const OldAnimation& old) {
    const auto found = old.sampler_of.find({node_of(channel.joint), Property::rotation});
    if (found == old.sampler_of.end()) return written(channel, nullptr);
    const Object sampler = Object::of(old.json["samplers"][found->second], "").value();
    const auto keys = sampler_keys(source_.document(), sampler, quaternion_type, source_.reading(),
                                   std::numeric_limits<std::size_t>::max());
    if (!keys) return tl::unexpected(keys.error());
    auto raw = channel_of<Eigen::Quaterniond>(*keys, channel.joint, Norm::as_in_file);
    auto read = channel_of<Eigen::Quaterniond>(*keys, channel.joint);
    if (!raw || !read) return tl::unexpected(raw ? read.error() : raw.error());
    const RotationOfFile of_file{std::move(*raw), std::move(*read)};
    return written(channel, &of_file);
  }

  [[nodiscard]] std::size_t node_of(std::size_t joint) const { return source_.nodes().node_of_joint[joint]; }

  [[nodiscard]] std::size_t sampler_of(const WrittenChannel& channel, SamplerList& samplers) {
    const ValueType& type = channel.property == Property::rotation ? quaternion_type : vector_type;
    const std::size_t input = result_.store.times(channel.times);
    return samplers.made(input, result_.store.outputs(channel.outputs, type.word, type.components),
                         channel.interpolation);
  }

  /// Channels that were there stay at their place in the list, with what else they say.
  void append(const Clip& clip, const OldAnimation& old, const std::vector<WrittenChannel>& written_channels) {
    std::map<Place, const WrittenChannel*> left;
    for (const WrittenChannel& channel : written_channels)
      left.emplace(Place(node_of(channel.joint), channel.property), &channel);
    SamplerList samplers;
    Json channels = Json::array();
    for (std::size_t i = 0; i < old.channels.size(); ++i) {
      const auto& target = old.channels[i].target;
      const auto found = target ? left.find({target->node, target->property}) : left.end();
      if (target && found == left.end()) continue;
      Json channel = old.json["channels"][i];
      channel["sampler"] =
          target ? sampler_of(*found->second, samplers) : samplers.kept(old.channels[i].sampler, old.json["samplers"]);
      channels.push_back(std::move(channel));
      if (target) left.erase(found);
    }
    for (const WrittenChannel& channel : written_channels) {
      const Place place(node_of(channel.joint), channel.property);
      if (left.contains(place))
        channels.push_back({{"sampler", sampler_of(channel, samplers)},
                            {"target", {{"node", place.first}, {"path", gltf::word_of(place.second)}}}});
    }
    append(clip, old, std::move(channels), std::move(samplers).list());
  }

  void append(const Clip& clip, const OldAnimation& old, Json channels, Json samplers) {
    const bool was_empty = old.channels.empty() && !old.json.empty();
    if (channels.empty() && !was_empty) {
      result_.warnings.push_back(
          {.code = "empty_clip",
           .message =
               formatted("clip {} has no keys and is left out, for glTF has no such animation", in_quotes(clip.name))});
      return;
    }
    Json animation = old.json;
    if (!channels.empty()) {
      animation["channels"] = std::move(channels);
      animation["samplers"] = std::move(samplers);
    }
    if (clip.name != old.name) animation["name"] = clip.name;
    result_.list.push_back(std::move(animation));
  }

  const Scene& scene_;
  const Source& source_;
  WrittenAnimations result_;
};

}  // namespace

Expected<AnimationPlan> plan_of(const Document& document, const std::vector<Clip>& clips) {
  const Json& animations = *document.root().list("animations").value();
  AnimationPlan plan{.of_clip = std::vector<std::optional<std::size_t>>(clips.size()),
                     .kept = KeptSamplers(animations.size())};
  std::multimap<std::string, std::size_t> by_name;
  for (std::size_t a = 0; a < animations.size(); ++a) {
    const auto animation = animation_of(document, a);
    if (!animation) return tl::unexpected(animation.error());
    auto name = animation_name(*animation, a);
    if (!name) return tl::unexpected(std::move(name.error()));
    by_name.emplace(std::move(*name), a);
    plan.kept[a].resize(animation->list("samplers").value()->size());
  }
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const auto found = by_name.lower_bound(clips[i].name);
    if (clips.size() == animations.size()) plan.of_clip[i] = i;
    else if (found != by_name.end() && found->first == clips[i].name) plan.of_clip[i] = by_name.extract(found).mapped();
    if (!plan.of_clip[i]) continue;
    const auto channels = animation_channels(document, animation_of(document, *plan.of_clip[i]).value());
    if (!channels) return tl::unexpected(channels.error());
    for (const AnimationChannel& channel : *channels)
      if (!channel.target) plan.kept[*plan.of_clip[i]][channel.sampler] = true;
  }
  return plan;
}

Expected<WrittenAnimations> written_animations(const Scene& scene, const Source& source, const AnimationPlan& plan,
                                               KeyStore store) {
  return Writer(scene, source, std::move(store)).all(plan);
}

}}}  // namespace orispline::scenes::gltf
