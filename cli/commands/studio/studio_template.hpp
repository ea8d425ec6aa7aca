// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace orispline::cli {

/// The page of the studio without its data, in pieces to be joined: studio.html, which `make studio` builds. Empty
/// where the command was built without it.
[[nodiscard]] std::span<const std::string_view> studio_template();

}  // namespace orispline::cli
