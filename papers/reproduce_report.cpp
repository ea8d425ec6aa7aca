// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce_report.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

std::string data_taken(const Experiment& experiment) {
  if (experiment.run_on) return "; takes --keys with --reference";
  return experiment.run_with ? "; takes --keys" : "";
}

}  // namespace

std::string text_of(std::span<const Experiment> experiments) {
  std::string text =
      "Run an experiment by one of its names. A paper's number or author alone runs all of its experiments, and `all` "
      "those of all papers.\n\n";
  for (const Experiment& experiment : experiments)
    text += formatted("{:16}{:19}{}{}\n", experiment.name, name_by_author(experiment), experiment.title,
                      data_taken(experiment));
  return text;
}

std::string text_of(const ExperimentReport& report) {
  std::string text = formatted("{}  {}\n", report.name, report.title);
  for (const report::Table& table : report.findings.tables) text += "\n" + report::text_of(table);
  for (const std::string& file : report.picture_files) text += formatted("\npicture: {}", file);
  return report.picture_files.empty() ? text : text + "\n";
}

std::string text_of(const std::vector<ExperimentReport>& reports) {
  std::string text;
  for (const ExperimentReport& report : reports) text += (text.empty() ? "" : "\n") + text_of(report);
  return text;
}

std::string files_text_of(const std::vector<ExperimentReport>& reports) {
  std::string text;
  for (const ExperimentReport& report : reports) {
    text += formatted("{}  {}\n", report.name, report.title);
    for (const auto* files : {&report.table_files, &report.picture_files})
      for (const std::string& file : *files) text += formatted("  {}\n", file);
  }
  return text;
}

}  // namespace orispline::cli
