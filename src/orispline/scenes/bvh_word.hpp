// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/scenes/bvh_text.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// The number that the last word of a text is. Errors (bad_data) name its line: no number, not finite, too large.
[[nodiscard]] Expected<double> number_of_length(const Text& text, std::string_view word);
[[nodiscard]] Expected<double> number_of_degrees(const Text& text, std::string_view word);
/// `wanted` is for the message.
[[nodiscard]] Expected<std::size_t> whole_number(const Text& text, std::string_view word, std::string_view wanted);

/// A name with U+FFFD for what is not UTF-8.
[[nodiscard]] std::string text_of_unicode(std::string_view name);

}}}  // namespace orispline::scenes::bvh
