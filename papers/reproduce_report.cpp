// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce_report.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

std::string text_of(std::span<const Experiment> experiments) {
  std::string text =
      "Run an experiment by one of its names. A paper's number or author alone runs all of its experiments.\n\n";
  for (const Experiment& experiment : experiments)
    text += formatted("{:16}{:19}{}{}\n", experiment.name, name_by_author(experiment), experiment.title,
                      experiment.run_with ? "; takes --keys" : "");
  return text;
}

std::string text_of(const std::vector<ExperimentReport>& reports) {
  std::string text;
  for (const ExperimentReport& report : reports) {
    text += formatted("{}{}  {}\n", text.empty() ? "" : "\n", report.name, report.title);
    for (const report::Table& table : report.findings.tables) text += "\n" + report::text_of(table);
    for (const std::string& file : report.picture_files) text += formatted("\npicture: {}", file);
    if (!report.picture_files.empty()) text += "\n";
  }
  return text;
}

}  // namespace orispline::cli
