// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/smooth.hpp>

#include "options/field_options.hpp"

namespace orispline::cli {

/// How a recording is smoothed, as typed.
struct SmoothnessOptions {
  TypedFields fields;  ///< of orispline::SmoothOptions
  std::optional<std::string> cutoff;
};

/// The first option by which something is said of how smooth it is to be; empty if nothing is.
[[nodiscard]] std::string first_given(const SmoothnessOptions& options);
[[nodiscard]] inline bool any_given(const SmoothnessOptions& options) { return !first_given(options).empty(); }

/// The options of smoothing, understood; all else is left at its default. Error: bad_argument.
[[nodiscard]] Expected<orispline::SmoothOptions> smoothing_in(const SmoothnessOptions& options);

/// An error about the smoothing time, which the user stated as a cutoff, in terms of that; any other as it is.
[[nodiscard]] Error said_of_cutoff(const SmoothnessOptions& options, Error error);

/// All options of smoothing.
void add_smoothing_options(Command& app, SmoothnessOptions& options);
/// How smooth a recording is made: one of them, or none where that is chosen.
void add_smoothness_options(Command& app, SmoothnessOptions& options);

}  // namespace orispline::cli
