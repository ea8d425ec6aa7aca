// SPDX-License-Identifier: Apache-2.0
// In the place of base/formatted.cpp where a program is to be small: a message is its text and its values, which others
// put together. It is \1 text \2 value \2 value … \3; a value is `s` and a text, which may be a message, or `d`, `i` or
// `u` and the bits of a number, sixteen letters from a to p.
#include <bit>
#include <cstdint>
#include <string>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

std::string number_text(char kind, std::uint64_t bits) {
  std::string text(1, kind);
  for (int shift = 60; shift >= 0; shift -= 4) text.push_back(static_cast<char>('a' + (bits >> shift & 15)));
  return text;
}

struct ValueText {
  std::string operator()(double number) const { return number_text('d', std::bit_cast<std::uint64_t>(number)); }
  std::string operator()(int number) const { return (*this)(static_cast<long long>(number)); }
  std::string operator()(unsigned number) const { return number_text('u', number); }
  std::string operator()(long long number) const { return number_text('i', static_cast<std::uint64_t>(number)); }
  std::string operator()(unsigned long long number) const { return number_text('u', number); }
  std::string operator()(bool is_true) const { return is_true ? "strue" : "sfalse"; }
  std::string operator()(char letter) const { return std::string("s") + letter; }
  std::string operator()(const char* text) const { return std::string("s") + text; }
  std::string operator()(fmt::string_view text) const { return "s" + std::string(text.data(), text.size()); }
  /// Of the types that no message has.
  template <class Other>
  std::string operator()(const Other&) const {
    return "s?";
  }
};

}  // namespace

std::string formatted_values(fmt::string_view text, fmt::format_args values) {
  std::string message = "\1" + std::string(text.data(), text.size());
  for (int i = 0; const auto value = values.get(i); ++i) message += "\2" + fmt::visit_format_arg(ValueText(), value);
  return message + "\3";
}

}}  // namespace orispline
