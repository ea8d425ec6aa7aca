// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <orispline/scenes/scene_format.hpp>

namespace orispline::inline ORISPLINE_ABI::scenes {
namespace {

constexpr std::array<std::string_view, 2> gltf_extensions{".glb", ".gltf"};

}  // namespace

constinit const SceneFormat gltf_format{.id = "gltf",
                                        .title = "glTF",
                                        .file = "a glTF file",
                                        .summary = "glTF 2.0, in one file or as text",
                                        .extensions = gltf_extensions};

}  // namespace orispline::inline ORISPLINE_ABI::scenes
