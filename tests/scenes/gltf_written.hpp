// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/scenes/gltf/json.hpp>

#include "scenes/gltf_file.hpp"

namespace orispline::scenes::test {

/// A document that was written, with its buffer.
struct WrittenFile {
  gltf::Json json{};
  std::string binary{};
  std::vector<Warning> warnings{};

  [[nodiscard]] std::string accessor_bytes(std::size_t index, std::size_t element_size) const {
    const gltf::Json& accessor = json["accessors"][index];
    const gltf::Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    return binary.substr(view.value("byteOffset", 0u) + accessor.value("byteOffset", 0u),
                         accessor["count"].get<std::size_t>() * element_size);
  }
};

inline WrittenFile written(const Scene& scene, std::string_view name = "out.glb") {
  const orispline::test::ScratchDirectory folder;
  const auto warnings = write_scene(scene, folder.file(name));
  EXPECT_TRUE(warnings) << describe(warnings.error());
  if (!warnings) return {};
  const std::string bytes = orispline::test::content_of(folder.file(name));
  const auto parts = gltf::container_of(bytes);
  EXPECT_TRUE(read_scene(folder.file(name)));
  return {gltf::parsed(parts->json).value(), std::string(parts->binary.value_or("")), *warnings};
}

inline std::string refusal(const Scene& scene) {
  const orispline::test::ScratchDirectory folder;
  const auto warnings = write_scene(scene, folder.file("out.glb"));
  return warnings ? "" : orispline::test::text_of(warnings.error());
}

inline Scene scene_of(const GltfFile& file) {
  auto scene = read(file.text());
  EXPECT_TRUE(scene) << describe(scene.error());
  return std::move(*scene);
}

}  // namespace orispline::scenes::test
