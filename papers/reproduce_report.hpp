// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "papers/experiment.hpp"

namespace orispline::cli {

/// One experiment, run.
struct ExperimentReport {
  std::string name, title;
  Findings findings;
  std::vector<std::string> picture_files{}, table_files{};  ///< paths of what was written
};

/// Pages for people.
[[nodiscard]] std::string text_of(std::span<const Experiment> experiments);
[[nodiscard]] std::string text_of(const ExperimentReport& report);
[[nodiscard]] std::string text_of(const std::vector<ExperimentReport>& reports);
/// Which files were written.
[[nodiscard]] std::string files_text_of(const std::vector<ExperimentReport>& reports);

/// Arrays of JSON objects, described in docs/inspect-json.md.
[[nodiscard]] std::string json_of(std::span<const Experiment> experiments);
[[nodiscard]] std::string json_of(const ExperimentReport& report);
[[nodiscard]] std::string json_of(const std::vector<ExperimentReport>& reports);
[[nodiscard]] std::string files_json_of(const std::vector<ExperimentReport>& reports);

}  // namespace orispline::cli
