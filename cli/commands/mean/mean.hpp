// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/output_options.hpp"
#include "options/several_inputs.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline mean`, as typed.
struct MeanArguments {
  SeveralInputs inputs;
  InputOptions input;
  TypedFields mean;                  ///< of orispline::MeanOptions
  OutputOptions output{.path = ""};  ///< empty: nothing is written, and what was found is printed
  SummaryOptions summary;
};

/// Rows of one or several files in, their mean or median out.
[[nodiscard]] Expected<void> mean(const MeanArguments& options);

}  // namespace orispline::cli
