// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/counted.hpp>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

std::string counted(std::size_t count, std::string_view noun) {
  return formatted("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}}  // namespace orispline
