// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <orispline/base/base64.hpp>
#include <orispline/scenes/gltf/document.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "io/text_file.hpp"

namespace orispline::scenes::test {

template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// A small document, made part by part. Its JSON may be replaced where a test wants something else.
struct GltfFile {
  std::string binary{};
  std::vector<std::string> views{}, accessors{}, animations{};
  std::string nodes = R"([{"name":"arm"}])";
  std::string more{};  ///< members of the document, each behind a comma

  std::size_t view(std::string_view bytes, std::string_view members = "") {
    binary.resize((binary.size() + 3) / 4 * 4);
    views.push_back(
        fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", binary.size(), bytes.size(), members));
    binary += bytes;
    return views.size() - 1;
  }
  /// `members`: of the accessor, each behind a comma.
  std::size_t accessor(std::string_view members, std::string_view bytes, std::string_view view_members = "") {
    const std::size_t place = view(bytes, view_members);
    accessors.push_back(fmt::format(R"({{"bufferView":{}{}}})", place, members));
    return accessors.size() - 1;
  }
  std::size_t floats(std::string_view type, const std::vector<float>& numbers) {
    const std::size_t width = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
    return accessor(fmt::format(R"(,"componentType":5126,"count":{},"type":"{}")", numbers.size() / width, type),
                    bytes_of(numbers));
  }
  /// An animation of one channel.
  void animate(std::size_t input, std::size_t output, std::string_view interpolation = "LINEAR",
               std::string_view path = "rotation") {
    animations.push_back(fmt::format(
        R"({{"name":"walk","samplers":[{{"input":{},"output":{},"interpolation":"{}"}}],"channels":[{{"sampler":0,"target":{{"node":0,"path":"{}"}}}}]}})",
        input, output, interpolation, path));
  }

  [[nodiscard]] std::string json(std::string_view buffer) const {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"nodes":{},"animations":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{}]{}}})",
        nodes, fmt::join(animations, ","), fmt::join(accessors, ","), fmt::join(views, ","), buffer, more);
  }
  [[nodiscard]] std::string text() const {
    return json(fmt::format(R"({{"byteLength":{},"uri":"data:application/octet-stream;base64,{}"}})", binary.size(),
                            base64_of(binary)));
  }
  [[nodiscard]] std::string glb() const {
    return gltf::glb_of(json(fmt::format(R"({{"byteLength":{}}})", binary.size())), binary).value();
  }
};

inline const std::vector<float> quarter_turns{0, 0, 0, 1, 0, 0, 0.70710677F, 0.70710677F, 0, 0, 1, 0};

/// A turn about z by two quarters at 0, 1 and 2 s.
inline GltfFile turning() {
  GltfFile file;
  const std::size_t times = file.floats("SCALAR", {0, 1, 2});
  file.animate(times, file.floats("VEC4", quarter_turns));
  return file;
}

inline Expected<Scene> read(const std::string& content, const SceneReading& reading = {}) {
  const orispline::test::TextFile file(content, "scene.gltf");
  return read_scene(file.path(), reading);
}

/// The one line for people, or of the first warning; empty where there is nothing to say.
inline std::string said_of(const std::string& content) {
  const auto scene = read(content);
  if (!scene) return orispline::test::text_of(scene.error());
  return scene->warnings.empty() ? "" : describe(scene->warnings.front());
}

}  // namespace orispline::scenes::test
