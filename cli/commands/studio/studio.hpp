// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "options/input_options.hpp"

namespace orispline::cli {

/// `orispline studio`, as typed.
struct StudioArguments {
  std::optional<std::string> keys;  ///< absent: the page begins with its start screen
  InputOptions reading;             ///< of that file, whose path is above
  std::optional<std::string> method, beside;
  std::optional<std::string> output;  ///< absent: a new file of the temporary folder
  bool no_open = false;
};

/// Keyframes in, a page on which they are edited out.
[[nodiscard]] Expected<void> studio(const StudioArguments& options);

}  // namespace orispline::cli
