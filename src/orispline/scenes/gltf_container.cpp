// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_container.hpp>

#include <array>
#include <cstdint>
#include <limits>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

constexpr std::string_view glb_magic = "glTF", json_type = "JSON", binary_type{"BIN\0", 4};
constexpr std::size_t header_size = 12, chunk_header_size = 8;
constexpr std::string_view base64_letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::uint32_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8 | byte_at(bytes, at + 2) << 16 | byte_at(bytes, at + 3) << 24;
}

void append_number(std::string& bytes, std::size_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xFF);
}

tl::unexpected<Error> bad(std::string message) { return failure(ErrorCode::bad_data, std::move(message)); }

struct Chunk {
  std::string_view type{}, content{};
};

Expected<Chunk> chunk_at(std::string_view bytes, std::size_t at) {
  if (bytes.size() - at < chunk_header_size)
    return bad(formatted("found {} bytes at byte {}, wanted a chunk of a GLB", bytes.size() - at, at));
  const std::size_t length = number_at(bytes, at), room = bytes.size() - at - chunk_header_size;
  if (length > room)
    return bad(formatted("found a chunk of {} bytes at byte {}, wanted at most the {} that follow", length, at, room));
  return Chunk{bytes.substr(at + 4, 4), bytes.substr(at + chunk_header_size, length)};
}

Expected<Container> glb_parts(std::string_view bytes) {
  if (bytes.size() < header_size) return bad(formatted("found {} bytes, wanted a whole GLB", bytes.size()));
  if (const std::uint32_t version = number_at(bytes, 4); version != 2)
    return bad(formatted("found GLB version {}, wanted 2", version));
  const std::size_t length = number_at(bytes, 8);
  if (length > bytes.size() || length < header_size)
    return bad(formatted("found a GLB of {} bytes that states {}, wanted a whole one", bytes.size(), length));
  bytes = bytes.substr(0, length);
  Container parts;
  for (std::size_t at = header_size; at < length;) {
    const auto chunk = chunk_at(bytes, at);
    if (!chunk) return tl::unexpected(chunk.error());
    if (at == header_size && chunk->type != json_type) return bad("found a GLB without a JSON chunk, wanted it first");
    if (at == header_size) parts.json = chunk->content;
    if (chunk->type == binary_type && !parts.binary) parts.binary = chunk->content;
    at += chunk_header_size + chunk->content.size();
  }
  if (length == header_size) return bad("found a GLB without a JSON chunk, wanted it first");
  return parts;
}

constexpr std::array<signed char, 256> base64_values() {
  std::array<signed char, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < base64_letters.size(); ++i)
    values[static_cast<unsigned char>(base64_letters[i])] = static_cast<signed char>(i);
  return values;
}

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

}  // namespace

Expected<Container> container_of(std::string_view bytes) {
  if (bytes.substr(0, glb_magic.size()) == glb_magic) return glb_parts(bytes);
  return Container{.json = bytes};
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

std::optional<std::string> from_base64(std::string_view text) {
  static constexpr auto values = base64_values();
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t held = 0;
  int bits = 0;
  for (const char letter : text) {
    const int value = values[static_cast<unsigned char>(letter)];
    if (value < 0) return std::nullopt;
    held = held << 6 | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 0xFF);
  }
  return bytes;
}

std::string base64_of(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t three =
        byte_at(bytes, i) << 16 | (left > 1 ? byte_at(bytes, i + 1) << 8 : 0) | (left > 2 ? byte_at(bytes, i + 2) : 0);
    text += base64_letters[three >> 18];
    text += base64_letters[three >> 12 & 63];
    text += left > 1 ? base64_letters[three >> 6 & 63] : '=';
    text += left > 2 ? base64_letters[three & 63] : '=';
  }
  return text;
}

}}}  // namespace orispline::scenes::gltf
