// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// The name of a file without its folders; text that ends with a folder is left as it is.
[[nodiscard]] constexpr std::string_view file_name_of(std::string_view path) noexcept {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos || slash + 1 == path.size() ? path : path.substr(slash + 1);
}

}  // namespace orispline::inline ORISPLINE_ABI
