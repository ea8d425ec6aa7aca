// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/clip/channel.hpp>
#include <orispline/scenes/gltf_document.hpp>
#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// What the sampler of an animation holds: per key a value, of splines a tangent, a value and a tangent.
struct SamplerKeys {
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  std::vector<double> times{};
  std::vector<double> outputs{};
  std::vector<std::string> strided{};  ///< accessors whose elements do not follow each other, by name

  [[nodiscard]] std::size_t size() const noexcept { return times.size(); }
};

/// How many numbers one value has, with the word of glTF.
struct ValueType {
  std::string_view word;
  std::size_t components;
};
inline constexpr ValueType quaternion_type{"VEC4", 4}, vector_type{"VEC3", 3};

/// The keys of a sampler; `most`: how many there may be. Errors (bad_data): accessors that do not fit each other, times
/// that do not rise.
[[nodiscard]] Expected<SamplerKeys> sampler_keys(const Document& document, const Object& sampler, const ValueType& type,
                                                 const SceneReading& reading, std::size_t most);

enum class Norm { one, as_in_file };

/// The channel; rotations are normalised, with their tangents in proportion, unless they are to be as in the file.
///
/// Errors (bad_data): a number that is not finite, a quaternion far from norm 1.
template <CurvePoint P>
[[nodiscard]] Expected<Channel<P>> channel_of(const SamplerKeys& keys, std::size_t joint, Norm norm = Norm::one);

}}}  // namespace orispline::scenes::gltf
