// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/optimise/reduce.hpp>

#include "input_options.hpp"
#include "output_options.hpp"
#include "report_file.hpp"

namespace orispline::cli {

inline constexpr std::array reduce_choices{
    Choice<std::optional<std::string_view>>{"auto", "auto"}, Choice<std::optional<std::string_view>>{"slerp", "slerp"},
    Choice<std::optional<std::string_view>>{"timed-c2", "timed-c2"},
    Choice<std::optional<std::string_view>>{"smallest", std::nullopt}};  ///< nothing: all of them

inline constexpr std::string_view default_reduce_method = "smallest";

/// `orispline reduce`, as typed.
struct ReduceOptions {
  InputOptions input;
  OutputOptions output;
  ReportOptions report;
  std::string tolerance, method{default_reduce_method};
  std::optional<std::string> position_tolerance;
  bool refit = false, json = false, quiet = false;
};

/// A dense recording in, the fewest keys whose curve is within the tolerance out.
[[nodiscard]] Expected<void> reduce(const ReduceOptions& options);

}  // namespace orispline::cli
