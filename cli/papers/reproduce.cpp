// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce.hpp"

#include <filesystem>
#include <iterator>

#include <orispline/base/formatted.hpp>
#include <orispline/io/output_file.hpp>

#include "options/option_text.hpp"
#include "output/noted_output.hpp"
#include "output/output_folder.hpp"
#include "output/standard_output.hpp"
#include "papers/reproduce_report.hpp"

namespace orispline::cli {
namespace {

namespace fs = std::filesystem;

/// The experiment of that name, or all of the paper of that number.
Expected<std::vector<Experiment>> chosen(std::string_view name) {
  std::vector<Experiment> found;
  std::vector<std::string_view> names;
  for (const Experiment& experiment : experiments()) {
    const std::string_view paper = experiment.name.substr(0, experiment.name.find('-'));
    if (experiment.name == name || paper == name) found.push_back(experiment);
    if (names.empty() || names.back() != paper) names.push_back(paper);
  }
  for (const Experiment& experiment : experiments()) names.push_back(experiment.name);
  if (found.empty()) return usage_failure(formatted("no experiment '{}', wanted one of {}", name, joined(names, ", ")));
  return found;
}

/// Writes a picture into the folder; its path.
Expected<std::string> write_picture(const std::string& folder, const Picture& picture) {
  std::string path = (fs::path(folder) / (picture.name + ".svg")).string();
  return open_output(path)
      .and_then([&](Noted<io::OutputFile> output) {
        return output.file.write(picture.drawing.document()).and_then([&] { return output.file.finish(); });
      })
      .map([&] { return std::move(path); });
}

Expected<std::vector<ExperimentReport>> run_all(const std::vector<Experiment>& selected) {
  std::vector<ExperimentReport> reports;
  for (const Experiment& experiment : selected) {
    auto findings = experiment.run();
    if (!findings) return tl::unexpected(std::move(findings.error()));
    reports.push_back({std::string(experiment.name), std::string(experiment.title), std::move(*findings), {}});
  }
  return reports;
}

Expected<void> write_pictures(std::vector<ExperimentReport>& reports, const std::string& folder) {
  if (auto made = make_folder(folder); !made) return made;
  for (ExperimentReport& report : reports)
    for (const Picture& picture : report.findings.pictures) {
      auto path = write_picture(folder, picture);
      if (!path) return tl::unexpected(std::move(path.error()));
      report.picture_files.push_back(std::move(*path));
    }
  return {};
}

}  // namespace

Expected<void> reproduce(const ReproduceOptions& options) {
  if (!options.experiment) {
    if (options.pictures) return wanted({"--pictures", *options.pictures}, "an EXPERIMENT as well");
    return print_document(options.json ? json_of(experiments()) : text_of(experiments()));
  }
  if (options.pictures && options.pictures->empty()) return wanted({"--pictures", ""}, "a folder");
  auto reports = chosen(*options.experiment).and_then(run_all);
  if (!reports) return tl::unexpected(std::move(reports.error()));
  if (options.pictures)
    if (auto written = write_pictures(*reports, *options.pictures); !written) return written;
  return print_document(options.json ? json_of(*reports) : text_of(*reports));
}

}  // namespace orispline::cli
