// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/fields/json.hpp>

namespace orispline::cli {

/// As text, by nlohmann's, which is slow to compile. What is not UTF-8, as file names may be, is shown with replacement
/// characters.
[[nodiscard]] std::string document(const Json& json);

}  // namespace orispline::cli
