// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/fields/json.hpp>

namespace orispline::c {

/// As text in one line; numbers that are not finite are null.
[[nodiscard]] std::string json_text(const Json& json);

}  // namespace orispline::c
