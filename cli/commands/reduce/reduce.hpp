// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options/field_options.hpp"
#include "options/input_options.hpp"
#include "options/method_options.hpp"
#include "options/output_options.hpp"
#include "options/several_inputs.hpp"
#include "options/smoothness.hpp"
#include "output/report_file.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

/// In the place of a method: of those that are tried where none is named, the one with the fewest keys.
inline constexpr std::string_view smallest_method = "smallest";

/// `orispline reduce`, as typed.
struct ReduceArguments {
  SeveralInputs inputs;
  InputOptions input;  ///< how they are read
  OutputOptions output;
  ReportOptions report;
  TypedFields reduction;                      ///< of orispline::ReduceOptions
  TypedFields scene;                          ///< of orispline::ClipReduceOptions, what that has beside them
  bool closed = false;                        ///< of clips
  std::optional<std::string> position_scale;  ///< of clips: metres in a unit of the file
  std::string method{smallest_method};
  MethodOptions shape;
  SmoothnessOptions smoothness;
  bool smooth = false;
  SummaryOptions summary;
};

/// What the files ask of each other. Error: bad_argument.
[[nodiscard]] Expected<void> check_files(const ReduceArguments& options);

/// Dense recordings in, for each the fewest keys whose curve is within the tolerance out.
[[nodiscard]] Expected<void> reduce(const ReduceArguments& options);

}  // namespace orispline::cli
