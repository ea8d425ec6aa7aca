// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/formatted.hpp>

#include <fmt/format.h>

namespace orispline { inline namespace ORISPLINE_ABI {

std::string formatted_values(fmt::string_view text, fmt::format_args values) { return fmt::vformat(text, values); }

}}  // namespace orispline
