// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline bake`, as typed.
struct BakeArguments {
  InputOptions input;
  std::optional<std::string> method;
  MethodOptions shape;
  TypedFields baking;  ///< of jobs::BakeSettings
  std::string output{io::standard_stream};
  SummaryOptions summary;
};

/// Keyframes in, the curve through them as polynomials out.
[[nodiscard]] Expected<void> bake(const BakeArguments& options);

}  // namespace orispline::cli
