// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_document.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/gltf_buffers.hpp>
#include <orispline/scenes/gltf_container.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

Expected<void> check_version(const Object& root) {
  return root.object("asset").and_then([](const Object& asset) -> Expected<void> {
    const auto version = asset.text("version");
    if (!version) return tl::unexpected(version.error());
    const auto least = asset.text_or("minVersion", "2.0");
    if (!least) return tl::unexpected(least.error());
    if (!version->starts_with("2.")) return asset.fault(formatted("found version {}, wanted 2.0", in_quotes(*version)));
    if (*least != "2.0") return asset.fault(formatted("found minVersion {}, wanted 2.0", in_quotes(*least)));
    return {};
  });
}

Expected<void> check_lists(const Object& root) {
  for (const char* key : {"accessors", "bufferViews", "buffers", "nodes", "animations", "scenes"})
    if (const auto list = root.list(key); !list) return tl::unexpected(list.error());
  return {};
}

Expected<std::optional<View>> view_of(const Object& view, const std::vector<BufferPlace>& buffers) {
  const auto buffer = view.index("buffer", buffers.size());
  if (!buffer) return tl::unexpected(buffer.error());
  const auto offset = view.count_or("byteOffset", 0), length = view.count("byteLength");
  if (!offset) return tl::unexpected(offset.error());
  if (!length) return tl::unexpected(length.error());
  const auto stride = view.count_or("byteStride", 0);
  if (!stride) return tl::unexpected(stride.error());
  const BufferPlace& place = buffers[*buffer];
  if (*offset + *length > place.length)
    return view.fault(formatted("found {} bytes from byte {}, wanted them within the {} bytes of buffer {}", *length,
                                *offset, place.length, *buffer));
  if (!place.has_data) return std::nullopt;
  return View{place.offset + *offset, *length, *stride};
}

Expected<std::vector<std::optional<View>>> views_of(const Object& root, const std::vector<BufferPlace>& buffers) {
  std::vector<std::optional<View>> views(root.list("bufferViews").value()->size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto view = root.entry("bufferViews", "bufferView", i).and_then([&](const Object& entry) {
      return view_of(entry, buffers);
    });
    if (!view) return tl::unexpected(view.error());
    views[i] = *view;
  }
  return views;
}

bool is_harmless(std::string_view extension) {
  static constexpr std::array<std::string_view, 6> families{"KHR_materials_", "KHR_texture_",   "EXT_texture_",
                                                            "EXT_lights_",    "EXT_materials_", "MSFT_texture_"};
  static constexpr std::array<std::string_view, 13> names{"KHR_mesh_quantization",
                                                          "KHR_lights_punctual",
                                                          "KHR_draco_mesh_compression",
                                                          "KHR_animation_pointer",
                                                          "KHR_node_visibility",
                                                          "KHR_xmp_json_ld",
                                                          "KHR_gaussian_splatting",
                                                          "KHR_audio_emitter",
                                                          "EXT_mesh_gpu_instancing",
                                                          "EXT_mesh_features",
                                                          "EXT_structural_metadata",
                                                          "EXT_instance_features",
                                                          "MSFT_lod"};
  return std::ranges::any_of(families, [&](std::string_view family) { return extension.starts_with(family); }) ||
         std::ranges::find(names, extension) != names.end();
}

/// What is wanted instead of an extension that changes how animations are stored; empty for others.
std::string_view wanted_instead_of(std::string_view extension) {
  if (extension == "EXT_meshopt_compression" || extension == "KHR_meshopt_compression" ||
      extension == "MESHOPT_compression")
    return "uncompressed animations";
  if (extension == "KHR_accessor_float64") return "animations in single precision";
  if (extension.starts_with("MPEG_")) return "animations that are whole in the file";
  return {};
}

}  // namespace

Expected<Document> document_of(std::string_view bytes, const std::string& path) {
  const auto parts = container_of(bytes);
  if (!parts) return tl::unexpected(parts.error());
  auto json = parsed(parts->json);
  if (!json) return tl::unexpected(std::move(json.error()));
  if (!json->is_object()) return failure(ErrorCode::bad_data, "found JSON that is no object, wanted a glTF document");
  Document document{.json = std::move(*json)};
  if (auto sound = check_version(document.root()); !sound) return tl::unexpected(std::move(sound.error()));
  if (auto sound = check_lists(document.root()); !sound) return tl::unexpected(std::move(sound.error()));
  auto buffers = buffers_of(document.root(), parts->binary, path);
  if (!buffers) return tl::unexpected(std::move(buffers.error()));
  auto views = views_of(document.root(), buffers->places);
  if (!views) return tl::unexpected(std::move(views.error()));
  document.binary = std::move(buffers->bytes);
  document.views = std::move(*views);
  return document;
}

Expected<std::vector<Warning>> extension_warnings(const Document& document) {
  const auto required = document.root().list("extensionsRequired");
  if (!required) return tl::unexpected(required.error());
  std::vector<Warning> warnings;
  for (const Json& entry : **required) {
    const auto* name = entry.get_ptr<const Json::string_t*>();
    if (name == nullptr)
      return failure(ErrorCode::bad_data,
                     formatted("found {} in extensionsRequired, wanted names of extensions", shown(entry)));
    const std::string extension = printable(std::string_view(*name).substr(0, 80));
    if (const std::string_view wanted = wanted_instead_of(extension); !wanted.empty())
      return failure(ErrorCode::bad_data, formatted("extension {} is required, wanted {}", extension, wanted));
    if (!is_harmless(extension))
      warnings.push_back(
          {.code = "unknown_extension",
           .message = formatted("extension {} is required and not known here; it is passed on unread", extension)});
  }
  return warnings;
}

}}}  // namespace orispline::scenes::gltf
