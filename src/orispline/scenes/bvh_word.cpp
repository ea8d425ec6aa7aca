// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh_word.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr double greatest_length = 1e100;  // so that squares and sums of them are finite
constexpr double greatest_angle = 1e9;     // [°], beyond which little is left of the fraction of a turn

Expected<double> number_below(double limit, const Text& text, std::string_view word) {
  if (word.empty()) return text.refused(word, "a number");
  const Expected<double> number = io::number_of(word);
  if (!number) return text.fault(number.error().message);
  if (!std::isfinite(*number)) return text.refused(word, "a finite number");
  if (std::abs(*number) > limit) return text.refused(word, formatted("a number of at most {:g} in size", limit));
  return *number;
}

/// The bytes of the character that a text begins with; 0 where it is no UTF-8.
std::size_t character_bytes(std::string_view text) noexcept {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = at(0);
  if (first < 0x80) return 1;
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return 0;
  for (std::size_t i = 1; i < bytes; ++i)
    if ((at(i) & 0xC0u) != 0x80u) return 0;
  const bool is_overlong = (first == 0xE0 && at(1) < 0xA0) || (first == 0xF0 && at(1) < 0x90);
  const bool is_surrogate = first == 0xED && at(1) >= 0xA0, is_beyond = first == 0xF4 && at(1) >= 0x90;
  return is_overlong || is_surrogate || is_beyond ? 0 : bytes;
}

}  // namespace

Expected<double> number_of_length(const Text& text, std::string_view word) {
  return number_below(greatest_length, text, word);
}

Expected<double> number_of_degrees(const Text& text, std::string_view word) {
  return number_below(greatest_angle, text, word);
}

Expected<std::size_t> whole_number(const Text& text, std::string_view word, std::string_view wanted) {
  std::size_t number = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (status != std::errc() || end != word.data() + word.size()) return text.refused(word, wanted);
  return number;
}

std::string text_of_unicode(std::string_view name) {
  std::string text;
  while (!name.empty()) {
    const std::size_t bytes = character_bytes(name);
    if (bytes == 0) text += "\xEF\xBF\xBD";
    else text += name.substr(0, bytes);
    name.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return text;
}

}}}  // namespace orispline::scenes::bvh
