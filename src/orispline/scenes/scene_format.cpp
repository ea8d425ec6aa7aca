// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/scene_format.hpp>

#include <algorithm>
#include <array>

namespace orispline::inline ORISPLINE_ABI::scenes {
namespace {

constexpr std::array all_formats{&bvh_format, &gltf_format};

char small_letter(char letter) noexcept {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
}

}  // namespace

bool SceneFormat::has_extension_of(std::string_view path) const noexcept {
  return std::ranges::any_of(extensions, [&](std::string_view extension) {
    return path.size() > extension.size() &&
           std::ranges::equal(path.substr(path.size() - extension.size()), extension, {}, small_letter);
  });
}

std::span<const SceneFormat* const> scene_formats() noexcept { return all_formats; }

const SceneFormat* scene_format_of(std::string_view path) noexcept {
  const auto found =
      std::ranges::find_if(all_formats, [&](const SceneFormat* format) { return format->has_extension_of(path); });
  return found == all_formats.end() ? nullptr : *found;
}

}  // namespace orispline::inline ORISPLINE_ABI::scenes
