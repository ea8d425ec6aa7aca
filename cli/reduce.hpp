// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/reduce/reduce.hpp>

#include "input_options.hpp"
#include "output_options.hpp"
#include "report_file.hpp"
#include "smoothness.hpp"
#include "summary.hpp"

namespace orispline::cli {

inline constexpr std::array reduce_choices{
    Choice<std::optional<std::string_view>>{"auto", "auto"}, Choice<std::optional<std::string_view>>{"slerp", "slerp"},
    Choice<std::optional<std::string_view>>{"timed-c2", "timed-c2"},
    Choice<std::optional<std::string_view>>{"smallest", std::nullopt}};  ///< nothing: all of them

inline constexpr std::string_view default_reduce_method = "smallest";

/// `orispline reduce`, as typed.
struct ReduceOptions {
  std::vector<std::string> inputs;
  InputOptions input;  ///< how they are read
  OutputOptions output;
  ReportOptions report;
  std::string tolerance, method{default_reduce_method};
  std::optional<std::string> position_tolerance, folder, threads;
  SmoothnessOptions smoothness;
  bool refit = false, smooth = false;
  SummaryOptions summary;
};

/// Dense recordings in, for each the fewest keys whose curve is within the tolerance out. Nothing is written before all
/// of them are found.
[[nodiscard]] Expected<void> reduce(const ReduceOptions& options);

}  // namespace orispline::cli
