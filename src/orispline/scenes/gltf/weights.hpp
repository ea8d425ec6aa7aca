// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/scenes/gltf/document.hpp>

// Weights of morph targets, whose samplers have as many numbers per key as the node has targets.

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// What a sampler says of a joint's weights. Nothing where it is broken, has integers or more than `most` numbers: then
/// it is passed on as it is.
[[nodiscard]] std::optional<WeightChannels> weights_in(const Document& document, const Object& sampler,
                                                       std::size_t joint, std::size_t most);

/// The weights of a clip that a channel of its old animation has otherwise; null where they are as they were, or are
/// not known.
[[nodiscard]] const WeightChannels* changed_weights(const Source& source, const Clip& clip, const Object& animation,
                                                    const AnimationChannel& channel);

/// Keys of all weights together, as a sampler has them.
struct WeightKeys {
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  std::vector<double> times{};
  std::vector<double> numbers{};  ///< per key the values; of cubics all tangents before it, the values, those behind
};

/// With keys at the times of all channels, which stay the curves that they are.
[[nodiscard]] WeightKeys keys_of(const WeightChannels& weights);

}}}  // namespace orispline::scenes::gltf
