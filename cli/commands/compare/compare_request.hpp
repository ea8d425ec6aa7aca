// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>

#include "commands/compare/compare.hpp"
#include "options/method_options.hpp"

namespace orispline::cli {

/// A method with its settings, and as the user names it: `quintic:tension=0.6`.
struct NamedMethod {
  std::string label;
  Method method;
};

/// The command line of `orispline compare`, understood.
struct CompareRequest {
  InputRequest input;
  std::vector<Decimation> decimations{};  ///< none: the keys are INPUT itself
  std::vector<NamedMethod> methods{};
  std::vector<std::string> named{};  ///< labels of those that were typed one by one
  MeasureOptions measured{};
  bool tune = false;  ///< methods with tensions once more, tuned
  std::string sort;   ///< the word of a measure
  std::size_t threads = 1;
};

/// Errors: bad_argument.
[[nodiscard]] Expected<CompareRequest> compare_request(const CompareOptions& options);

}  // namespace orispline::cli
