// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <utility>

// Without the code of fmt, of which every source would make its own: only those that include <fmt/format.h> have it.
#pragma push_macro("FMT_HEADER_ONLY")
#undef FMT_HEADER_ONLY
#if __has_include(<fmt/base.h>)
#include <fmt/base.h>
#else
#include <fmt/core.h>
#endif
#pragma pop_macro("FMT_HEADER_ONLY")

#include <orispline/base/abi.hpp>

// The door to fmt, which is header-only inside the library: its formatting is compiled once, behind this door, and not
// in every source that writes a message.

namespace orispline { inline namespace ORISPLINE_ABI {

[[nodiscard]] std::string formatted_values(fmt::string_view text, fmt::format_args values);

/// The text with the values in its braces, which are checked when this is compiled: `formatted("found {}", 3)`.
template <class... Values>
[[nodiscard]] std::string formatted(fmt::format_string<Values...> text, Values&&... values) {
  return formatted_values(text, fmt::make_format_args(values...));
}

/// The words or numbers of a list, each in this format, with the separator between them.
template <class List>
[[nodiscard]] std::string joined(const List& list, std::string_view separator,
                                 fmt::format_string<decltype(*std::begin(std::declval<const List&>()))> each = "{}") {
  std::string text;
  std::string_view before;
  for (const auto& part : list) {
    text.append(before).append(formatted(each, part));
    before = separator;
  }
  return text;
}

}}  // namespace orispline
