// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/document.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/base64.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/file_system.hpp>
#include <orispline/scenes/gltf/compressed_views.hpp>
#include <orispline/scenes/gltf/json.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

constexpr std::string_view glb_magic = "glTF", json_type = "JSON", binary_type{"BIN\0", 4};
constexpr std::size_t header_size = 12, chunk_header_size = 8;

std::uint32_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8 | byte_at(bytes, at + 2) << 16 | byte_at(bytes, at + 3) << 24;
}

void append_number(std::string& bytes, std::size_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xFF);
}

tl::unexpected<Error> bad(std::string message) { return failure(ErrorCode::bad_data, std::move(message)); }

struct Chunk {
  std::string_view type{};
  std::size_t length = 0;
};

/// The header of the chunk at that byte of a GLB of `size` bytes.
Expected<Chunk> chunk_at(std::string_view bytes, std::size_t at, std::size_t size) {
  if (size - at < chunk_header_size)
    return bad(formatted("found {} bytes at byte {}, wanted a chunk of a GLB", size - at, at));
  const std::size_t length = number_at(bytes, at), room = size - at - chunk_header_size;
  if (length > room)
    return bad(formatted("found a chunk of {} bytes at byte {}, wanted at most the {} that follow", length, at, room));
  return Chunk{bytes.substr(at + 4, 4), length};
}

/// How many bytes a GLB states, of a file of `size` bytes that begins so; its first chunk is sound.
Expected<std::size_t> stated_size(std::string_view start, std::size_t size) {
  if (size < header_size) return bad(formatted("found {} bytes, wanted a whole GLB", size));
  if (const std::uint32_t version = number_at(start, 4); version != 2)
    return bad(formatted("found GLB version {}, wanted 2", version));
  const std::size_t stated = number_at(start, 8);
  if (stated > size || stated < header_size)
    return bad(formatted("found a GLB of {} bytes that states {}, wanted a whole one", size, stated));
  if (stated == header_size) return bad("found a GLB without a JSON chunk, wanted it first");
  const auto chunk = chunk_at(start, header_size, stated);
  if (!chunk) return tl::unexpected(chunk.error());
  if (chunk->type != json_type) return bad("found a GLB without a JSON chunk, wanted it first");
  return stated;
}

Expected<Container> glb_parts(std::string_view bytes) {
  const auto stated = stated_size(bytes, bytes.size());
  if (!stated) return tl::unexpected(stated.error());
  Container parts;
  for (std::size_t at = header_size; at < *stated;) {
    const auto chunk = chunk_at(bytes, at, *stated);
    if (!chunk) return tl::unexpected(chunk.error());
    const std::string_view content = bytes.substr(at + chunk_header_size, chunk->length);
    if (at == header_size) parts.json = content;
    if (chunk->type == binary_type && !parts.binary) parts.binary = content;
    at += chunk_header_size + content.size();
  }
  return parts;
}

bool is_glb(std::string_view start) { return start.starts_with(glb_magic); }

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

struct Buffers {
  std::string bytes{};
  std::size_t bytes_beside = 0;  ///< of the files that they were in
  std::vector<BufferPlace> places{};
};

int hexadecimal(char digit) {
  if (digit >= '0' && digit <= '9') return digit - '0';
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
  return -1;
}

std::string percent_decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hexadecimal(uri[i + 1]) : -1;
    const int low = high < 0 ? -1 : hexadecimal(uri[i + 2]);
    text += low < 0 ? uri[i] : static_cast<char>(high * 16 + low);
    if (low >= 0) i += 2;
  }
  return text;
}

/// Whether it stays in its folder or one below, wherever it is opened.
bool is_beside(std::string_view name) {
  if (name.empty() || name.front() == '/' || name.find_first_of(std::string_view("\\:\0", 3)) != std::string_view::npos)
    return false;
  for (std::size_t start = 0; start <= name.size();) {
    const std::size_t end = std::min(name.find('/', start), name.size());
    if (name.substr(start, end - start) == "..") return false;
    start = end + 1;
  }
  return true;
}

/// The bytes of a buffer, and how many the file has that it is in.
struct BufferBytes {
  std::string bytes;
  std::size_t beside = 0;
};

/// A buffer that the file describes, of so many bytes.
struct DescribedBuffer {
  const Object& json;
  std::size_t length;
  const io::Input& from;
};

std::string too_few(std::size_t found, std::size_t wanted) {
  return formatted("found {} bytes, wanted the {} of its byteLength", found, wanted);
}

/// A file of strangers must not make us wait for a pipe, nor carry other files of yours into what is written; no more
/// of it is read than the buffer has.
Expected<BufferBytes> file_in_folder(const DescribedBuffer& buffer, std::string_view uri, const std::string& folder,
                                     const std::string& name) {
  const std::string file = folder + name;
  const io::Place place = io::place_at(file);
  if (place.kind == io::PlaceKind::folder || place.kind == io::PlaceKind::other)
    return buffer.json.fault(
        formatted("found uri {}, which is a folder, a pipe or a device, wanted a file", in_quotes(uri)));
  if (!io::stays_within(folder, file))
    return buffer.json.fault(formatted(
        "found uri {}, a link to another folder, wanted a file beside the glTF file; copy it there", in_quotes(uri)));
  if (place.size > 0 && place.size < buffer.length) return buffer.json.fault(too_few(place.size, buffer.length));
  return bytes_of_file(file, nullptr, buffer.length).map([&place](std::string bytes) {
    return BufferBytes{std::move(bytes), place.size};
  });
}

Expected<BufferBytes> file_beside(const DescribedBuffer& buffer, std::string_view uri) {
  const std::string name = percent_decoded(uri);
  if (!is_beside(uri) || !is_beside(name))
    return buffer.json.fault(formatted("found uri {}, wanted a file beside the glTF file", in_quotes(uri)));
  if (const io::Input* const beside = buffer.from.beside(name))
    return BufferBytes{std::string(beside->bytes()), beside->bytes().size()};
  if (buffer.from.is_in_memory())
    return buffer.json.fault(formatted(
        "found uri {}, which is not given, wanted the bytes within the document, as a .glb has them", in_quotes(uri)));
  const std::string& path = buffer.from.name();
  return file_in_folder(buffer, uri, path.substr(0, path.size() - file_name_of(path).size()), name);
}

bool is_data(std::string_view uri) { return uri.starts_with("data:"); }

Expected<BufferBytes> data_of(const DescribedBuffer& buffer, std::string_view uri) {
  if (!is_data(uri)) return file_beside(buffer, uri);
  constexpr std::string_view mark = ";base64,";
  const std::size_t found = uri.find(mark);
  auto bytes = found == std::string_view::npos ? std::nullopt : bytes_from_base64(uri.substr(found + mark.size()));
  if (!bytes) return buffer.json.fault("found a data uri that is not base64, wanted one that is");
  return BufferBytes{std::move(*bytes)};
}

/// The bytes of one buffer; nothing where it has none.
Expected<std::optional<BufferBytes>> bytes_of(const DescribedBuffer& buffer, std::optional<std::string_view> chunk) {
  if (!buffer.json.has("uri")) return chunk ? std::optional(BufferBytes{std::string(*chunk)}) : std::nullopt;
  return buffer.json.text("uri").and_then([&](const std::string& uri) { return data_of(buffer, uri); });
}

/// The buffers with one more.
Expected<Buffers> with(Buffers all, const Object& buffer, std::optional<std::string_view> chunk,
                       const io::Input& from) {
  const auto length = buffer.count("byteLength");
  if (!length) return tl::unexpected(length.error());
  auto found = bytes_of({buffer, *length, from}, chunk);
  if (!found) return tl::unexpected(std::move(found.error()));
  all.places.push_back({.offset = (all.bytes.size() + 7) / 8 * 8, .length = *length, .has_data = found->has_value()});
  const std::size_t offset = all.places.back().offset;
  if (!all.places.back().has_data) return all;
  auto& [bytes, beside] = **found;
  all.bytes_beside += beside;
  if (bytes.size() < *length) return buffer.fault(too_few(bytes.size(), *length));
  if (offset + *length > largest_scene_file) return buffer.fault("found more than 2 GiB of buffers, wanted less");
  bytes.resize(*length);
  if (offset == 0) {
    all.bytes = std::move(bytes);
  } else {
    all.bytes.resize(offset);
    all.bytes += bytes;
  }
  return all;
}

/// The buffers of a document, one behind the other, each at a multiple of 8.
///
/// `binary`: the chunk of a GLB. Errors: bad_data; bad_access for a file that is not beside the document or cannot be
/// read.
Expected<Buffers> buffers_of(const Object& root, std::optional<std::string_view> binary, const io::Input& from) {
  Buffers buffers;
  const std::size_t count = root.list("buffers").value()->size();
  for (std::size_t i = 0; i < count; ++i) {
    auto more = root.entry("buffers", "buffer", i).and_then([&](const Object& buffer) {
      return with(std::move(buffers), buffer, i == 0 ? binary : std::nullopt, from);
    });
    if (!more) return more;
    buffers = std::move(*more);
  }
  return buffers;
}

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
  return is_meshopt(extension) ||  // of animations it is decoded, of meshes passed on
         std::ranges::any_of(families, [&](std::string_view family) { return extension.starts_with(family); }) ||
         std::ranges::find(names, extension) != names.end();
}

/// What is wanted instead of an extension that changes how animations are stored; empty for others.
std::string_view wanted_instead_of(std::string_view extension) {
  if (extension == "KHR_accessor_float64") return "animations in single precision";
  if (extension.starts_with("MPEG_")) return "animations that are whole in the file";
  return {};
}

}  // namespace

Expected<Container> container_of(std::string_view bytes) {
  if (is_glb(bytes)) return glb_parts(bytes);
  return Container{.json = bytes};
}

Expected<void> check_start(std::string_view start, std::size_t size, const std::string&) {
  if (is_glb(start)) return stated_size(start, size).map([](std::size_t) {});
  return check_start_of_json(start);
}

Expected<std::string> glb_of(std::string_view json, std::string_view binary) {
  const std::size_t chunks = binary.empty() ? 1 : 2;
  const std::size_t size =
      header_size + chunks * chunk_header_size + padded(json.size()) + (binary.empty() ? 0 : padded(binary.size()));
  if (size > std::numeric_limits<std::uint32_t>::max())
    return bad(formatted("found {} bytes to write, wanted less than 4 GiB, which a GLB can hold", size));
  std::string bytes(glb_magic);
  bytes.reserve(size);
  append_number(bytes, 2);
  append_number(bytes, size);
  append_number(bytes, padded(json.size()));
  bytes.append(json_type).append(json).append(padded(json.size()) - json.size(), ' ');
  if (binary.empty()) return bytes;
  append_number(bytes, padded(binary.size()));
  bytes.append(binary_type).append(binary).append(padded(binary.size()) - binary.size(), '\0');
  return bytes;
}

Expected<Document> document_of(std::string_view bytes, const io::Input& from) {
  const auto parts = container_of(bytes);
  if (!parts) return tl::unexpected(parts.error());
  auto json = parsed(parts->json);
  if (!json) return tl::unexpected(std::move(json.error()));
  if (!json->is_object()) return failure(ErrorCode::bad_data, "found JSON that is no object, wanted a glTF document");
  Document document{.json = std::move(*json)};
  if (auto sound = check_version(document.root()); !sound) return tl::unexpected(std::move(sound.error()));
  if (auto sound = check_lists(document.root()); !sound) return tl::unexpected(std::move(sound.error()));
  auto buffers = buffers_of(document.root(), parts->binary, from);
  if (!buffers) return tl::unexpected(std::move(buffers.error()));
  auto views = views_of(document.root(), buffers->places);
  if (!views) return tl::unexpected(std::move(views.error()));
  document.binary = std::move(buffers->bytes);
  document.bytes_beside = buffers->bytes_beside;
  document.buffers = std::move(buffers->places);
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
