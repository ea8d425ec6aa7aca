// SPDX-License-Identifier: Apache-2.0
#include "commands/studio/studio_template.hpp"

namespace orispline::cli {

std::span<const std::string_view> studio_template() { return {}; }

}  // namespace orispline::cli
