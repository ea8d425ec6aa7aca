// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smooth.hpp>

#include "options/input_options.hpp"
#include "options/output_options.hpp"
#include "options/smoothness.hpp"
#include "output/report_file.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

inline constexpr std::array penalty_choices{
    Choice<orispline::Penalty>{"acceleration", orispline::Penalty::acceleration},
    Choice<orispline::Penalty>{"jerk", orispline::Penalty::jerk}};
inline constexpr std::array loss_choices{
    Choice<orispline::Loss>{"robust", orispline::Loss::robust}, Choice<orispline::Loss>{"l2", orispline::Loss::l2},
    Choice<orispline::Loss>{"huber", orispline::Loss::huber}, Choice<orispline::Loss>{"tukey", orispline::Loss::tukey}};

/// The method that makes the C2 curve of smoothed keys.

/// `orispline smooth`, as typed.
struct SmoothOptions {
  InputOptions input;
  std::optional<std::string> penalty, loss, gyro_noise, gap, rate;
  SmoothnessOptions smoothness;
  bool gyro = false;
  OutputOptions output;
  ReportOptions report;
  SummaryOptions summary;
};

/// A noisy recording in, smooth keys with rates, or samples, out.
[[nodiscard]] Expected<void> smooth(const SmoothOptions& options);

}  // namespace orispline::cli
