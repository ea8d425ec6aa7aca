// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/tune/objective.hpp>

#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

inline constexpr std::array objective_choices{
    Choice<orispline::Objective>{"linearised", orispline::Objective::linearised},
    Choice<orispline::Objective>{"acceleration", orispline::Objective::acceleration},
    Choice<orispline::Objective>{"torque", orispline::Objective::torque},
    Choice<orispline::Objective>{"jerk", orispline::Objective::jerk},
    Choice<orispline::Objective>{"fit", orispline::Objective::fit}};

inline constexpr std::string_view default_tuned_method = "timed-c2";

/// `orispline tune`, as typed.
struct TuneOptions {
  InputOptions input;
  std::string method{default_tuned_method};
  MethodOptions shape;
  std::optional<std::string> objective, inertia, reference, bounds, free;
  std::string output{io::standard_stream};
  SummaryOptions summary;
};

/// Keyframes in, the same with the best tensions out.
[[nodiscard]] Expected<void> tune(const TuneOptions& options);

}  // namespace orispline::cli
