// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/input_options.hpp"
#include "options/output_options.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// `orispline convert`, as typed.
struct ConvertArguments {
  InputOptions input;
  OutputOptions output;
  std::optional<std::string> rate;
  bool no_bones = false;
  SummaryOptions summary;
};

/// Writes the keys in another format: exact times, and of the quaternions the very digits unless their norm is off.
[[nodiscard]] Expected<void> convert(const ConvertArguments& options);

}  // namespace orispline::cli
