// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <memory>
#include <utility>

#include <orispline/scenes/gltf_animation.hpp>
#include <orispline/scenes/gltf_source.hpp>
#include <orispline/scenes/gltf_writer.hpp>
#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace {

constexpr std::array<std::string_view, 2> gltf_extensions{".glb", ".gltf"};

Expected<Scene> scene_of(gltf::Document document, const SceneReading& reading) {
  Scene scene;
  auto nodes = gltf::nodes_of(document);
  if (!nodes) return tl::unexpected(std::move(nodes.error()));
  auto warnings = gltf::extension_warnings(document);
  if (!warnings) return tl::unexpected(std::move(warnings.error()));
  scene.skeleton = nodes->skeleton;
  scene.warnings = std::move(*warnings);
  gltf::AnimationReader animations(document, *nodes, reading);
  for (std::size_t i = document.root().list("animations").value()->size(); i > 0; --i) {
    auto clip = animations.next();
    if (!clip) return tl::unexpected(std::move(clip.error()));
    scene.clips.push_back(std::move(*clip));
  }
  for (Warning& warning : animations.warnings()) scene.warnings.push_back(std::move(warning));
  scene.source = std::make_shared<const gltf::Source>(std::move(document), std::move(*nodes), reading);
  return scene;
}

Expected<Scene> read_gltf(std::string_view bytes, const std::string& path, const SceneReading& reading) {
  return gltf::document_of(bytes, path).and_then([&](gltf::Document document) {
    return scene_of(std::move(document), reading);
  });
}

}  // namespace

constinit const SceneFormat gltf_format{.id = "gltf",
                                        .title = "glTF",
                                        .file = "a glTF file",
                                        .summary = "glTF 2.0, in one file or as text",
                                        .extensions = gltf_extensions,
                                        .read = read_gltf,
                                        .write = gltf::written_scene};

}}}  // namespace orispline::scenes
