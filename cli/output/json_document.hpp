// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace orispline::cli {

using Json = nlohmann::ordered_json;  // members stay in the order in which they are documented

/// Text that is not UTF-8, as file names may be, is shown with replacement characters.
[[nodiscard]] inline std::string document(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace orispline::cli
