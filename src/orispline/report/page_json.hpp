// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// The JSON document that the page reads; `<` stands as \u003c in it, so that no text can end the script around it.
[[nodiscard]] std::string json_of(const Page& page);

/// The JSON document that the page reads, as json_of(const Page&).
[[nodiscard]] std::string json_of(const SkeletonPage& page);

}}}  // namespace orispline::report
