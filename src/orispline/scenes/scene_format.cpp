// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/scene_file.hpp>

#include <algorithm>
#include <vector>

#include <orispline/base/file_name.hpp>
#include <orispline/scenes/assimp.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace {

const std::vector<const SceneFormat*>& all_formats() {
  static const std::vector<const SceneFormat*> all = [] {
    std::vector<const SceneFormat*> list{&bvh_format, &gltf_format};
    const auto more = assimp_formats();
    list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

}  // namespace

bool SceneFormat::has_extension_of(std::string_view path) const noexcept {
  return std::ranges::any_of(extensions, [path](std::string_view extension) { return has_extension(path, extension); });
}

std::span<const SceneFormat* const> scene_formats() noexcept { return all_formats(); }

const SceneFormat* scene_format_named(std::string_view id) noexcept {
  const auto found = std::ranges::find(all_formats(), id, &SceneFormat::id);
  return found == all_formats().end() ? nullptr : *found;
}

const SceneFormat* scene_format_of(std::string_view path) noexcept {
  const auto found =
      std::ranges::find_if(all_formats(), [&](const SceneFormat* format) { return format->has_extension_of(path); });
  return found == all_formats().end() ? nullptr : *found;
}

}}}  // namespace orispline::scenes
