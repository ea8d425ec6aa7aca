// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/warning.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

double Warning::number(std::string_view name) const noexcept {
  for (const auto& [known, value] : numbers)
    if (known == name) return value;
  return 0.0;
}

std::string describe(const Warning& warning) {
  return describe(Error{ErrorCode::bad_data, warning.message, warning.where, warning.option, {}});
}

}}  // namespace orispline
