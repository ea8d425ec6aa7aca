// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/smooth/smooth.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

/// How smooth a recording is made, as typed: one of them, or none where that is chosen.
struct SmoothnessOptions {
  std::optional<std::string> noise, smoothing_time, cutoff;
};

/// A finite number above 0.
[[nodiscard]] Expected<double> positive_in(OptionText option);

/// The same, understood; all else is left at its default.
[[nodiscard]] Expected<orispline::SmoothOptions> smoothing_in(const SmoothnessOptions& options);

}  // namespace orispline::cli
