// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// `orispline methods`, as typed.
struct MethodsOptions {
  bool json = false;
};

/// Lists the methods with what they promise and accept.
[[nodiscard]] Expected<void> methods(const MethodsOptions& options);

}  // namespace orispline::cli
