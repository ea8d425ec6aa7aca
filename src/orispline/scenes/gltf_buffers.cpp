// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_buffers.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/gltf_container.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

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

Expected<std::string> file_beside(const Object& buffer, std::string_view uri, const std::string& path) {
  const std::string name = percent_decoded(uri);
  if (!is_beside(uri) || !is_beside(name))
    return buffer.fault(formatted("found uri {}, wanted a file beside the glTF file", in_quotes(uri)));
  return bytes_of_file(path.substr(0, path.size() - file_name_of(path).size()) + name);
}

Expected<std::string> data_of(const Object& buffer, std::string_view uri, const std::string& path) {
  if (!uri.starts_with("data:")) return file_beside(buffer, uri, path);
  constexpr std::string_view mark = ";base64,";
  const std::size_t found = uri.find(mark);
  auto bytes = found == std::string_view::npos ? std::nullopt : from_base64(uri.substr(found + mark.size()));
  if (!bytes) return buffer.fault("found a data uri that is not base64, wanted one that is");
  return std::move(*bytes);
}

/// The bytes of one buffer; nothing where it has none.
Expected<std::optional<std::string>> bytes_of(const Object& buffer, std::optional<std::string_view> chunk,
                                              const std::string& path) {
  if (!buffer.has("uri")) return chunk ? std::optional(std::string(*chunk)) : std::nullopt;
  return buffer.text("uri").and_then([&](const std::string& uri) { return data_of(buffer, uri, path); });
}

/// The buffers with one more.
Expected<Buffers> with(Buffers all, const Object& buffer, std::optional<std::string_view> chunk,
                       const std::string& path) {
  const auto length = buffer.count("byteLength");
  if (!length) return tl::unexpected(length.error());
  auto bytes = bytes_of(buffer, chunk, path);
  if (!bytes) return tl::unexpected(std::move(bytes.error()));
  all.places.push_back({.offset = (all.bytes.size() + 7) / 8 * 8, .length = *length, .has_data = bytes->has_value()});
  const std::size_t offset = all.places.back().offset;
  if (!all.places.back().has_data) return all;
  if ((*bytes)->size() < *length)
    return buffer.fault(formatted("found {} bytes, wanted the {} of its byteLength", (*bytes)->size(), *length));
  if (offset + *length > largest_scene_file) return buffer.fault("found more than 2 GiB of buffers, wanted less");
  (*bytes)->resize(*length);
  if (offset == 0) {
    all.bytes = std::move(**bytes);
  } else {
    all.bytes.resize(offset);
    all.bytes += **bytes;
  }
  return all;
}

}  // namespace

Expected<Buffers> buffers_of(const Object& root, std::optional<std::string_view> binary, const std::string& path) {
  Buffers buffers;
  const std::size_t count = root.list("buffers").value()->size();
  for (std::size_t i = 0; i < count; ++i) {
    auto more = root.entry("buffers", "buffer", i).and_then([&](const Object& buffer) {
      return with(std::move(buffers), buffer, i == 0 ? binary : std::nullopt, path);
    });
    if (!more) return more;
    buffers = std::move(*more);
  }
  return buffers;
}

}}}  // namespace orispline::scenes::gltf
