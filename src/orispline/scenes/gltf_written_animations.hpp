// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/scenes/gltf_key_store.hpp>
#include <orispline/scenes/gltf_source.hpp>
#include <orispline/scenes/gltf_uses.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// Which animation of the document each clip takes the place of: that at its place where there are as many, else the
/// next one of its name.
struct AnimationPlan {
  std::vector<std::optional<std::size_t>> of_clip{};
  KeptSamplers kept{};  ///< those of channels that are not ours, in animations that stay
};
[[nodiscard]] Expected<AnimationPlan> plan_of(const Document& document, const std::vector<Clip>& clips);

/// The list of animations, whose keys are in the store.
struct WrittenAnimations {
  Json list = Json::array();
  KeyStore store;
  std::vector<Warning> warnings{};
};

/// Errors (bad_data), which name the clip, the joint and the key: times that are one in single precision, or below 0.
[[nodiscard]] Expected<WrittenAnimations> written_animations(const Scene& scene, const Source& source,
                                                             const AnimationPlan& plan, KeyStore store);

}}}  // namespace orispline::scenes::gltf
