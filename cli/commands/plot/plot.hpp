// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/input_options.hpp"
#include "options/method_options.hpp"

namespace orispline::cli {

enum class BodyAxis { x, y, z };

inline constexpr std::array axis_choices{Choice<BodyAxis>{"x", BodyAxis::x}, Choice<BodyAxis>{"y", BodyAxis::y},
                                         Choice<BodyAxis>{"z", BodyAxis::z}};

/// `orispline plot`, as typed.
struct PlotOptions {
  InputOptions input;
  std::vector<std::string> methods;  ///< names, or lists of names with commas between them
  MethodOptions shape;
  std::string path{io::standard_stream};
  std::optional<std::string> axis, ghosts;
};

/// Keyframes in, a picture of the curves through them out.
[[nodiscard]] Expected<void> plot(const PlotOptions& options);

}  // namespace orispline::cli
