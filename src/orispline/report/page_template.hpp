// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// Where the JSON document of a page goes in the template.
inline constexpr std::string_view data_marker = "__ORISPLINE_REPORT_DATA__";

/// The page without its data, in pieces to be joined: page_template.html, which studio/report builds.
[[nodiscard]] std::span<const std::string_view> page_template();

}}}  // namespace orispline::report
