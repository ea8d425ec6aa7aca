// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/base64.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::string_view base64_letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::uint8_t no_value = 0xFF;

constexpr std::array<std::uint8_t, 256> base64_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(no_value);
  for (std::size_t i = 0; i < base64_letters.size(); ++i)
    values[static_cast<unsigned char>(base64_letters[i])] = static_cast<std::uint8_t>(i);
  return values;
}

}  // namespace

std::string base64_of(std::string_view bytes) {
  const auto byte_at = [bytes](std::size_t at) -> std::uint32_t {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
  };
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = byte_at(i) << 16 | byte_at(i + 1) << 8 | byte_at(i + 2);
    text += base64_letters[three >> 18];
    text += base64_letters[three >> 12 & 63];
    text += i + 1 < bytes.size() ? base64_letters[three >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? base64_letters[three & 63] : '=';
  }
  return text;
}

std::optional<std::string> bytes_from_base64(std::string_view text) {
  static constexpr auto values = base64_values();
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t held = 0;
  int bits = 0;
  for (const char letter : text) {
    const std::uint8_t value = values[static_cast<unsigned char>(letter)];
    if (value == no_value) return std::nullopt;
    held = held << 6 | value;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 0xFF);
  }
  return bytes;
}

}}  // namespace orispline
