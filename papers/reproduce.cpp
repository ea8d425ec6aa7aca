// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/pages/task_pages.hpp>

#include "options/option_text.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"
#include "papers/own_data.hpp"
#include "papers/reproduce_files.hpp"
#include "papers/reproduce_report.hpp"

namespace orispline::cli {

namespace {

/// The experiment of that name, or all of the paper of that number or author, or all there are.
Expected<std::vector<Experiment>> chosen(std::string_view name) {
  constexpr std::string_view all = "all";
  std::vector<Experiment> found;
  std::vector<std::string> words{std::string(all)};
  for (const Experiment& experiment : experiments()) {
    const std::string_view paper = experiment.paper(), author = author_of(experiment);
    const bool is_named = experiment.name == name || name_by_author(experiment) == name;
    if (is_named || paper == name || author == name || name == all) found.push_back(experiment);
    if (words.back() != author) words.insert(words.end(), {std::string(paper), std::string(author)});
  }
  if (!found.empty()) return found;
  for (const Experiment& experiment : experiments())
    words.insert(words.end(), {std::string(experiment.name), name_by_author(experiment)});
  return usage_failure(unknown_word("experiment", name, std::vector<std::string_view>(words.begin(), words.end())));
}

/// With the names of those experiments that satisfy it.
std::string names_where(bool (*is_meant)(const Experiment&)) {
  std::vector<std::string_view> names;
  for (const Experiment& experiment : experiments())
    if (is_meant(experiment)) names.push_back(experiment.name);
  return joined(names, ", ");
}

/// Those of them that take such data as the user has. Error (bad_argument): none does, or none takes the reference.
Expected<std::vector<Experiment>> taking_data(std::vector<Experiment> selected, const ReproduceArguments& options) {
  const auto takes_reference = [](const Experiment& experiment) { return experiment.run_on != nullptr; };
  const auto takes_keys = [](const Experiment& experiment) { return experiment.takes_keys(); };
  const bool any_takes_reference = std::ranges::any_of(selected, takes_reference);
  if (options.reference && !any_takes_reference)
    return wanted({"--reference", *options.reference},
                  formatted("it with one of {}: the others need no truth", names_where(takes_reference)));
  const bool has_reference = options.reference.has_value();
  std::erase_if(selected, [&](const Experiment& e) { return !e.run_with && !(has_reference && e.run_on); });
  if (!selected.empty()) return selected;
  if (any_takes_reference) return wanted({"--keys", *options.keys}, "--reference as well, which is the true motion");
  return wanted({"--keys", *options.keys},
                formatted("it with one of {}: the others have keys of their own", names_where(takes_keys)));
}

Expected<Findings> findings_of(const Experiment& experiment, const std::optional<OwnData>& own) {
  if (!own) return experiment.run();
  return experiment.run_on ? experiment.run_on(*own->flight) : experiment.run_with(own->keys);
}

Expected<std::vector<ExperimentReport>> run_all(const std::vector<Experiment>& selected,
                                                const std::optional<OwnData>& own) {
  std::vector<ExperimentReport> reports;
  for (const Experiment& experiment : selected) {
    auto findings = findings_of(experiment, own);
    if (!findings) return tl::unexpected(std::move(findings.error()));
    reports.push_back({std::string(experiment.name), std::string(experiment.title), std::move(*findings)});
  }
  return reports;
}

/// On the user's own data, where there is some.
Expected<std::vector<ExperimentReport>> run_on(std::vector<Experiment> selected, const ReproduceArguments& options) {
  if (!options.keys) return run_all(selected, std::nullopt);
  return taking_data(std::move(selected), options).and_then([&](const std::vector<Experiment>& taking) {
    return read_own_data(*options.keys, options.reference).and_then([&](const OwnData& own) {
      return run_all(taking, own);
    });
  });
}

/// What a page shows: the motions of all experiments, and the truth of those that have one.
struct Shown {
  std::string title = "Motions of the papers' experiments";
  std::vector<pages::NamedCurve> curves{};
  Keyframes truth{};
};

Shown shown_of(std::vector<ExperimentReport> reports) {
  std::erase_if(reports, [](const ExperimentReport& report) { return report.findings.motions.empty(); });
  const bool is_one = reports.size() == 1;
  Shown shown;
  if (is_one) shown.title = reports.front().title;
  for (ExperimentReport& report : reports) {
    const bool has_truth = report.findings.truth.size() > 0;
    if (has_truth) shown.truth = report.findings.truth;
    for (pages::NamedCurve& curve : report.findings.motions) {
      if (!is_one) curve.name = formatted("{}: {}", report.name, curve.name);
      curve.truth = has_truth ? pages::Truth::known : pages::Truth::unknown;
      shown.curves.push_back(std::move(curve));
    }
  }
  return shown;
}

Expected<void> write_page(ReportFile file, std::vector<ExperimentReport> reports) {
  const Shown shown = shown_of(std::move(reports));
  const auto made = file.write([&](auto head) {
    head.title = shown.title;
    return pages::curves_page(shown.curves, head, shown.truth);
  });
  return made.and_then([&] { return file.finish(); });
}

/// Error (bad_argument): there is nothing to show on a page.
Expected<void> check_motions(const std::vector<ExperimentReport>& reports, const ReportOptions& options) {
  const auto moves = [](const ExperimentReport& report) { return !report.findings.motions.empty(); };
  if (!options.path || std::ranges::any_of(reports, moves)) return {};
  return wanted({"--report", *options.path}, "it with an experiment that has motions, such as 000-figure3");
}

/// Error (bad_argument): options that say nothing without another, or contradict each other.
Expected<void> check(const ReproduceArguments& options) {
  if (!options.experiment)
    for (const auto& [option, value] :
         {std::pair{"--pictures", &options.pictures}, std::pair{"--output-folder", &options.folder},
          std::pair{"--keys", &options.keys}, std::pair{"--reference", &options.reference},
          std::pair{"--report", &options.report.path}})
      if (*value) return wanted({option, **value}, "an EXPERIMENT as well");
  for (const auto& [option, folder] :
       {std::pair{"--pictures", &options.pictures}, std::pair{"--output-folder", &options.folder}})
    if (*folder && (*folder)->empty()) return wanted({option, ""}, "a folder");
  if (options.pictures && options.folder)
    return wanted({"--pictures", *options.pictures}, "it without --output-folder, where the pictures are too");
  if (options.reference && !options.keys) return wanted({"--reference", *options.reference}, "--keys as well");
  return check_report(options.report,
                      {{"--keys", options.keys.value_or("")}, {"--reference", options.reference.value_or("")}});
}

Expected<void> write_files(std::vector<ExperimentReport>& reports, const ReproduceArguments& options) {
  if (options.folder) return write_all(reports, *options.folder);
  if (options.pictures) return write_pictures(reports, *options.pictures);
  return {};
}

std::string document_of(const std::vector<ExperimentReport>& reports, const ReproduceArguments& options) {
  if (options.folder) return options.json ? files_json_of(reports) : files_text_of(reports);
  return options.json ? json_of(reports) : text_of(reports);
}

}  // namespace

Expected<void> reproduce(const ReproduceArguments& options) {
  if (auto checked = check(options); !checked) return checked;
  if (!options.experiment) return print_document(options.json ? json_of(experiments()) : text_of(experiments()));
  auto selected = chosen(*options.experiment);
  if (!selected) return tl::unexpected(std::move(selected.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto reports = run_on(std::move(*selected), options);
  if (!reports) return tl::unexpected(std::move(reports.error()));
  if (auto checked = check_motions(*reports, options.report); !checked) return checked;
  return write_files(*reports, options)
      .and_then([&] { return print_document(document_of(*reports, options)); })
      .and_then([&] { return write_page(std::move(*page), std::move(*reports)); });
}

}  // namespace orispline::cli
