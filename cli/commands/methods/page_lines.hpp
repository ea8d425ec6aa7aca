// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/curve/family.hpp>

// What the list of methods and the page of one have in common.

namespace orispline::cli {

/// `head` and the words behind it, broken before they leave the page and continued below themselves.
[[nodiscard]] std::string wrapped(const std::string& head, std::string_view words);

/// The columns of a file that a family reads rates from.
[[nodiscard]] std::string_view rate_columns_of(const FamilyInfo& family);

/// The columns of a file that a family reads inner quaternions from.
[[nodiscard]] std::string inner_columns_of(const FamilyInfo& family);

/// Everything about one method.
[[nodiscard]] std::string page_of(const FamilyInfo& family);

}  // namespace orispline::cli
