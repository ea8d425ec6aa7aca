// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// `orispline methods`, as typed.
struct MethodsArguments {
  std::optional<std::string> name;
  std::vector<std::string> blending;  ///< files of methods of the user's own
  bool json = false;
};

/// Lists the methods with what they promise and accept, or says everything of one.
[[nodiscard]] Expected<void> methods(const MethodsArguments& options);

}  // namespace orispline::cli
