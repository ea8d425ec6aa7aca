// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/output_options.hpp"
#include "options/sample_times.hpp"
#include "options/several_inputs.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

inline constexpr std::array frame_choices{Choice<io::Frame>{"body", io::Frame::body},
                                          Choice<io::Frame>{"world", io::Frame::world}};

/// In the place of a method, of a file of skeletons: what the file says between its keys.
inline constexpr std::string_view stored_method = "stored";

/// `orispline sample`, as typed.
struct SampleArguments {
  SeveralInputs inputs;
  InputOptions input;  ///< how they are read
  std::optional<std::string> method;
  MethodOptions shape;
  TimeOptions times;
  OutputOptions output;
  std::optional<std::string> derivatives, frame, extrapolate, outside, truth, band;
  std::optional<std::string> tolerance, position_tolerance;  ///< of a file of skeletons
  bool align = false, mark_gaps = false;
  SummaryOptions summary;
};

/// What --outside and --extrapolate take beside the words of Extrapolation.
inline constexpr std::string_view leave_out = "leave-out";

/// Keyframes in, samples of the curve through them out, for each input.
[[nodiscard]] Expected<void> sample(const SampleArguments& options);

}  // namespace orispline::cli
