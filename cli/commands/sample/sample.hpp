// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/output_options.hpp"
#include "options/row_options.hpp"
#include "options/several_inputs.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline sample`, as typed.
struct SampleArguments {
  SeveralInputs inputs;
  InputOptions input;  ///< how they are read
  std::optional<std::string> method;
  MethodOptions shape;
  RowOptions rows;
  OutputOptions output;
  std::optional<std::string> truth;
  std::optional<std::string> tolerance, position_tolerance;  ///< of a file of skeletons
  bool align = false;
  SummaryOptions summary;
};

/// Keyframes in, samples of the curve through them out, for each input.
[[nodiscard]] Expected<void> sample(const SampleArguments& options);

}  // namespace orispline::cli
