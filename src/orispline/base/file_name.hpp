// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The name of a file without its folders; text that ends with a folder is left as it is.
[[nodiscard]] constexpr std::string_view file_name_of(std::string_view path) noexcept {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos || slash + 1 == path.size() ? path : path.substr(slash + 1);
}

/// From the last point of the name on, with it; empty where there is none but at the front of the name.
[[nodiscard]] constexpr std::string_view extension_of(std::string_view path) noexcept {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const std::size_t point = name.rfind('.');
  return point == std::string_view::npos || point == 0 || name == ".." ? std::string_view() : name.substr(point);
}

/// Whether a path ends in that extension, which is in small letters with its dot, in any case of letters; an extension
/// alone is the name of a file.
[[nodiscard]] constexpr bool has_extension(std::string_view path, std::string_view extension) noexcept {
  const auto small = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return path.size() > extension.size() && std::equal(extension.rbegin(), extension.rend(), path.rbegin(),
                                                      [small](char a, char b) { return a == small(b); });
}

}}  // namespace orispline
