// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/scenes/gltf_keys.hpp>
#include <orispline/scenes/gltf_nodes.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// What a channel of ours moves, by the words of glTF.
enum class Property { rotation, translation, scale };
[[nodiscard]] std::string_view word_of(Property property) noexcept;
/// Of that word; absent for what is not ours, such as weights.
[[nodiscard]] std::optional<Property> property_of(std::string_view word) noexcept;

/// A channel of an animation. One that moves something else, such as weights, has no target here and is passed on.
struct ChannelTarget {
  std::size_t node = 0;
  Property property = Property::rotation;
};
struct AnimationChannel {
  std::size_t sampler = 0;
  std::optional<ChannelTarget> target{};
};

/// The object of an animation; it was read before, or its errors are bad_data.
[[nodiscard]] Expected<Object> animation_of(const Document& document, std::size_t animation);
/// `animation 3` where it has no name.
[[nodiscard]] Expected<std::string> animation_name(const Object& animation, std::size_t index);
[[nodiscard]] Expected<std::vector<AnimationChannel>> animation_channels(const Document& document,
                                                                         const Object& animation);

/// Reads the animations of a document one by one.
class AnimationReader {
 public:
  AnimationReader(const Document& document, const Nodes& nodes, const SceneReading& reading)
      : document_(document), nodes_(nodes), reading_(reading) {}

  /// Errors (bad_data) name the clip, and the joint and the key where there are any.
  [[nodiscard]] Expected<Clip> next();

  /// Of the animations that were read.
  [[nodiscard]] std::vector<Warning> warnings() const;

 private:
  [[nodiscard]] Expected<Clip> with(Clip clip, const Object& sampler, const ChannelTarget& target);
  [[nodiscard]] Expected<SamplerKeys> keys_of(const Object& sampler, Property property);

  const Document& document_;
  const Nodes& nodes_;
  const SceneReading& reading_;
  std::size_t animation_ = 0;
  std::size_t keys_left_ = std::size_t{1} << 26;  ///< many channels of few bytes must not fill the memory
  std::vector<std::string> strided_{};
};

}}}  // namespace orispline::scenes::gltf
