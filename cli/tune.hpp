// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/optimise/objective.hpp>

#include "input_options.hpp"
#include "method_options.hpp"
#include "summary.hpp"

namespace orispline::cli {

inline constexpr std::array objective_choices{
    Choice<optimise::Objective>{"linearised", optimise::Objective::linearised},
    Choice<optimise::Objective>{"acceleration", optimise::Objective::acceleration},
    Choice<optimise::Objective>{"torque", optimise::Objective::torque},
    Choice<optimise::Objective>{"jerk", optimise::Objective::jerk},
    Choice<optimise::Objective>{"fit", optimise::Objective::fit}};

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
