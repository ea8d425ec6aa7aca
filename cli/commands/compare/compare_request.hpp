// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/jobs/compare.hpp>

#include "commands/compare/compare.hpp"
#include "options/method_options.hpp"

namespace orispline::cli {

/// The command line of `orispline compare`, understood.
struct CompareRequest {
  InputRequest input;
  jobs::CompareRequest job;  ///< but for the keys
};

/// Errors: bad_argument.
[[nodiscard]] Expected<CompareRequest> compare_request(const CompareArguments& options);

}  // namespace orispline::cli
