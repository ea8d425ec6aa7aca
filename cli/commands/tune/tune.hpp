// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline tune`, as typed.
struct TuneArguments {
  InputOptions input;
  std::optional<std::string> method;
  MethodOptions shape;
  TypedFields tuning;  ///< of orispline::TuneOptions
  std::string output{io::standard_stream};
  SummaryOptions summary;
};

/// Keyframes in, the same with the best tensions out.
[[nodiscard]] Expected<void> tune(const TuneArguments& options);

}  // namespace orispline::cli
