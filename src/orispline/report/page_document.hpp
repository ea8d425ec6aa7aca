// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

// How a JSON document comes into a page.

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// A text in quotes; `<` stands as \u003c, so that none can end the script around it.
[[nodiscard]] std::string text_json(std::string_view text);

/// A page in pieces, joined, with the document in the place of the marker. Precondition: the page has one.
[[nodiscard]] std::string page_with(std::span<const std::string_view> pieces, std::string_view marker,
                                    std::string_view document);

}}}  // namespace orispline::report
