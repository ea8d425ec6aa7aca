// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/jobs/plot.hpp>

#include "options/input_options.hpp"
#include "options/method_options.hpp"

namespace orispline::cli {

inline constexpr std::array axis_choices{Choice<jobs::BodyAxis>{"x", jobs::BodyAxis::x},
                                         Choice<jobs::BodyAxis>{"y", jobs::BodyAxis::y},
                                         Choice<jobs::BodyAxis>{"z", jobs::BodyAxis::z}};

/// `orispline plot`, as typed.
struct PlotArguments {
  InputOptions input;
  std::vector<std::string> methods;  ///< each time one method, or a list with commas
  MethodOptions shape;
  std::string path{io::standard_stream};
  std::optional<std::string> axis, ghosts;
};

/// Keyframes in, a picture of the curves through them out.
[[nodiscard]] Expected<void> plot(const PlotArguments& options);

}  // namespace orispline::cli
