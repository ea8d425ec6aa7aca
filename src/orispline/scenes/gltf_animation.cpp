// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_animation.hpp>

#include <array>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

constexpr std::array all_properties{Property::rotation, Property::translation, Property::scale};

Expected<std::optional<ChannelTarget>> target_of(const Object& target, std::size_t nodes) {
  const auto path = target.text("path");
  if (!path) return tl::unexpected(path.error());
  for (const Property property : all_properties) {
    if (*path != word_of(property) || !target.has("node")) continue;
    return target.index("node", nodes).map([&](std::size_t node) {
      return std::optional(ChannelTarget{node, property});
    });
  }
  return std::nullopt;
}

}  // namespace

std::optional<Property> property_of(std::string_view word) noexcept {
  const auto found = std::ranges::find(all_properties, word, [](Property property) { return word_of(property); });
  return found == all_properties.end() ? std::nullopt : std::optional(*found);
}

std::string_view word_of(Property property) noexcept {
  switch (property) {
    case Property::rotation:
      return "rotation";
    case Property::translation:
      return "translation";
    case Property::scale:
      break;
  }
  return "scale";
}

Expected<Object> animation_of(const Document& document, std::size_t animation) {
  return document.root().entry("animations", "animation", animation);
}

Expected<std::string> animation_name(const Object& animation, std::size_t index) {
  return animation.text_or("name", "").map([&](std::string name) {
    return name.empty() ? formatted("animation {}", index) : std::move(name);
  });
}

Expected<std::vector<AnimationChannel>> animation_channels(const Document& document, const Object& animation) {
  const auto samplers = animation.list("samplers");
  if (!samplers) return tl::unexpected(samplers.error());
  const auto list = animation.list("channels");
  if (!list) return tl::unexpected(list.error());
  const std::size_t nodes = document.root().list("nodes").value()->size();
  std::vector<AnimationChannel> channels((*list)->size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto channel = animation.entry("channels", "channel", i);
    if (!channel) return tl::unexpected(channel.error());
    const auto sampler = channel->index("sampler", (*samplers)->size());
    if (!sampler) return tl::unexpected(sampler.error());
    const auto target = channel->object("target").and_then([&](const Object& read) { return target_of(read, nodes); });
    if (!target) return tl::unexpected(target.error());
    channels[i] = {*sampler, *target};
  }
  return channels;
}

Expected<Clip> AnimationReader::next() {
  const std::size_t index = animation_++;
  const auto animation = animation_of(document_, index);
  if (!animation) return tl::unexpected(animation.error());
  auto name = animation_name(*animation, index);
  if (!name) return tl::unexpected(std::move(name.error()));
  const auto channels = animation_channels(document_, *animation);
  if (!channels) return tl::unexpected(channels.error());
  Clip clip{.name = std::move(*name)};
  for (const AnimationChannel& channel : *channels) {
    if (!channel.target) continue;
    const std::string place = place_of(nodes_.skeleton, clip, nodes_.joint_of_node[channel.target->node]);
    auto more = animation->entry("samplers", "sampler", channel.sampler).and_then([&](const Object& sampler) {
      return with(std::move(clip), sampler, *channel.target);
    });
    if (!more) return tl::unexpected(within(place, std::move(more.error())));
    clip = std::move(*more);
  }
  return clip;
}

Expected<Clip> AnimationReader::with(Clip clip, const Object& sampler, const ChannelTarget& target) {
  auto keys = keys_of(sampler, target.property);
  if (!keys) return tl::unexpected(std::move(keys.error()));
  const std::size_t joint = nodes_.joint_of_node[target.node];
  if (target.property == Property::rotation)
    return channel_of<Eigen::Quaterniond>(*keys, joint).map([&](RotationChannel channel) {
      clip.rotations.push_back(std::move(channel));
      return std::move(clip);
    });
  auto& channels = target.property == Property::translation ? clip.translations : clip.scales;
  return channel_of<Eigen::Vector3d>(*keys, joint).map([&](VectorChannel channel) {
    channels.push_back(std::move(channel));
    return std::move(clip);
  });
}

Expected<SamplerKeys> AnimationReader::keys_of(const Object& sampler, Property property) {
  const ValueType& type = property == Property::rotation ? quaternion_type : vector_type;
  auto keys = sampler_keys(document_, sampler, type, reading_, keys_left_);
  if (!keys) return keys;
  keys_left_ -= keys->size();
  strided_.insert(strided_.end(), keys->strided.begin(), keys->strided.end());
  return keys;
}

std::vector<Warning> AnimationReader::warnings() const {
  if (strided_.empty()) return {};
  return {
      {.code = "strided_animation",
       .message = formatted("{} of animations in a bufferView with a byteStride, which glTF forbids there; they were "
                            "read by it, the first is {}",
                            counted(strided_.size(), "accessor"), strided_.front())}};
}

}}}  // namespace orispline::scenes::gltf
