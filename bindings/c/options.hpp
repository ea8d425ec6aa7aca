// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "errors.hpp"

namespace orispline::c {

/// Options by their names: of `name=value` what stands behind the first sign, of a name alone, a flag, `true`. Error
/// (bad_argument): a text that is null or has no name.
[[nodiscard]] inline Expected<std::vector<std::pair<std::string, std::string>>> stated_options(
    const char* const* texts, std::size_t count, std::string_view of_flags = "true") {
  const auto all = texts_in(texts, count, "options");
  if (!all) return tl::unexpected(all.error());
  std::vector<std::pair<std::string, std::string>> stated;
  for (const std::string_view text : *all) {
    const std::size_t sign = text.find('=');
    if (sign == 0 || text.empty()) return bad_option("options", "found '" + std::string(text) + "', wanted name=value");
    stated.emplace_back(text.substr(0, sign), sign == text.npos ? of_flags : text.substr(sign + 1));
  }
  return stated;
}

}  // namespace orispline::c
