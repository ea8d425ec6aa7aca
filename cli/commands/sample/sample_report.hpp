// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_columns.hpp>
#include <orispline/jobs/curve_clip.hpp>
#include <orispline/jobs/sample_steps.hpp>

#include "commands/sample/sample_request.hpp"
#include "output/json_document.hpp"

namespace orispline::cli {

/// What `orispline sample` did.
struct SampleReport {
  jobs::SampleOutcome outcome{};
  std::string input{}, output{};
  io::RepairReport repairs{};
  io::SampleColumns columns{};
  bool keys_held = false;  ///< all at once, in memory
};

/// Writes the samples of a curve in memory, of which the report has the outcome so far.
[[nodiscard]] Expected<SampleReport> write_samples(const SampleRequest& request, SampleReport report,
                                                   const PoseCurve& curve, const jobs::SampleTimes& times,
                                                   bool has_gaps = false, const jobs::Band* band = nullptr);

/// A curve in a file of skeletons, and the names of the files.
struct CurveSceneReport {
  jobs::CurveClipOutcome outcome;
  std::string output{};
};

/// A few lines for people.
[[nodiscard]] std::string text_of(const SampleReport& report);
[[nodiscard]] std::string text_of(const CurveSceneReport& report);
/// In one line, of one of several inputs.
[[nodiscard]] std::string line_of(const SampleReport& report);

/// The JSON documents, described in docs/inspect-json.md.
[[nodiscard]] Json json_of(const SampleReport& report);
[[nodiscard]] Json json_of(const CurveSceneReport& report);

}  // namespace orispline::cli
