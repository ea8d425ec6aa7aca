// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Text of strangers, such as a name of a file or of a column, fit for one line of a terminal: control characters (C0,
/// DEL and C1, line ends among them) and bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string printable(std::string_view text, char instead = '?');

/// Text of strangers as documents hold it: U+FFFD stands for each byte that is not UTF-8.
[[nodiscard]] std::string text_of_unicode(std::string_view text);

/// Text of a file as a message shows it: in quotes, cut after `longest` bytes, and printable.
[[nodiscard]] std::string in_quotes(std::string_view text, std::size_t longest = 40);

}}  // namespace orispline
