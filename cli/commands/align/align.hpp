// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/output_options.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline align`, as typed.
struct AlignArguments {
  InputOptions input;
  std::string reference;
  TypedFields alignment;             ///< of orispline::AlignOptions
  OutputOptions output{.path = ""};  ///< empty: nothing is written, and what was found is printed
  SummaryOptions summary;
};

/// A recording in the axes, on the clock and, with positions, at the place and in the unit of another one.
[[nodiscard]] Expected<void> align(const AlignArguments& options);

}  // namespace orispline::cli
