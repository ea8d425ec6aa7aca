// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/scenes/gltf_animation.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// A channel in single precision, as the file holds it.
struct WrittenChannel {
  std::size_t joint = 0;
  Property property = Property::rotation;
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  std::vector<float> times{};
  float end = 0.0F;              ///< of the last key, also where that was left out
  std::vector<float> outputs{};  ///< of splines with a tangent before and after each value
};

/// A channel of rotations as a file of the scene held it, to write the same bits again where they were not changed:
/// `read` is `raw` normalised.
struct RotationOfFile {
  RotationChannel raw{}, read{};
};

/// Signs of neighbours agree, but those of splines stay; a channel that does not move has one key. Errors (bad_data): a
/// time below 0, times that do not rise in single precision, a number beyond it.
[[nodiscard]] Expected<WrittenChannel> written(const RotationChannel& channel, const RotationOfFile* of_file);
[[nodiscard]] Expected<WrittenChannel> written(const VectorChannel& channel, Property property);

/// With its last key again, which was left out because nothing moves.
[[nodiscard]] WrittenChannel held_to_end(WrittenChannel channel);

}}}  // namespace orispline::scenes::gltf
