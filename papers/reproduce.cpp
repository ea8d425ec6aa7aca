// SPDX-License-Identifier: Apache-2.0
#include "papers/reproduce.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/io/output_file.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/pages/task_pages.hpp>

#include "options/option_text.hpp"
#include "output/noted_output.hpp"
#include "output/output_folder.hpp"
#include "output/report_file.hpp"
#include "output/standard_output.hpp"
#include "papers/reproduce_report.hpp"

namespace orispline::cli {

namespace {

namespace fs = std::filesystem;

/// The experiment of that name, or all of the paper of that number or author.
Expected<std::vector<Experiment>> chosen(std::string_view name) {
  std::vector<Experiment> found;
  std::vector<std::string> words;
  for (const Experiment& experiment : experiments()) {
    const std::string_view paper = experiment.paper(), author = author_of(experiment);
    const bool is_named = experiment.name == name || name_by_author(experiment) == name;
    if (is_named || paper == name || author == name) found.push_back(experiment);
    if (words.empty() || words.back() != author) words.insert(words.end(), {std::string(paper), std::string(author)});
  }
  if (!found.empty()) return found;
  for (const Experiment& experiment : experiments())
    words.insert(words.end(), {std::string(experiment.name), name_by_author(experiment)});
  return usage_failure(unknown_word("experiment", name, std::vector<std::string_view>(words.begin(), words.end())));
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

/// Those of them that take other keys. Error (bad_argument): none does.
Expected<std::vector<Experiment>> taking_keys(std::vector<Experiment> selected, std::string_view file) {
  const auto takes_none = [](const Experiment& experiment) { return !experiment.run_with; };
  std::erase_if(selected, takes_none);
  if (!selected.empty()) return selected;
  std::vector<std::string_view> names;
  for (const Experiment& experiment : experiments())
    if (experiment.run_with) names.push_back(experiment.name);
  return wanted({"--keys", file},
                formatted("it with one of {}: the others have keys of their own", joined(names, ", ")));
}

/// The keys of a file in the place of the paper's.
Expected<KeysInstead> keys_of(const std::string& file) {
  constexpr std::size_t least = 4;  // that every scheme takes
  auto track = io::read_track(file);
  if (!track) return tl::unexpected(std::move(track.error()));
  warn(track->warnings);
  Keyframes& keys = track->track.keys;
  if (keys.size() < least)
    return failure(ErrorCode::bad_data, formatted("found {} keys, wanted {} at least", keys.size(), least),
                   {.file = file});
  return KeysInstead{std::move(keys), formatted("The keys are those of {}.", printable(file))};
}

Expected<std::vector<ExperimentReport>> run_all(const std::vector<Experiment>& selected,
                                                const std::optional<KeysInstead>& keys) {
  std::vector<ExperimentReport> reports;
  for (const Experiment& experiment : selected) {
    auto findings = keys ? experiment.run_with(*keys) : experiment.run();
    if (!findings) return tl::unexpected(std::move(findings.error()));
    reports.push_back({std::string(experiment.name), std::string(experiment.title), std::move(*findings), {}});
  }
  return reports;
}

/// With the keys of that file, where one is given.
Expected<std::vector<ExperimentReport>> run_on(std::vector<Experiment> selected,
                                               const std::optional<std::string>& file) {
  if (!file) return run_all(selected, std::nullopt);
  return taking_keys(std::move(selected), *file).and_then([&](const std::vector<Experiment>& taking) {
    return keys_of(*file).and_then([&](const KeysInstead& keys) { return run_all(taking, keys); });
  });
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

/// What a page shows: the motions of all experiments; with a truth, if it is that of all.
struct Shown {
  std::string title = "Motions of the papers' experiments";
  std::vector<pages::NamedCurve> curves{};
  Keyframes truth{};
};

Shown shown_of(std::vector<ExperimentReport> reports) {
  std::erase_if(reports, [](const ExperimentReport& report) { return report.findings.motions.empty(); });
  if (reports.size() == 1)
    return {reports.front().title, std::move(reports.front().findings.motions), reports.front().findings.truth};
  Shown shown;
  for (ExperimentReport& report : reports)
    for (pages::NamedCurve& curve : report.findings.motions) {
      curve.name = formatted("{}: {}", report.name, curve.name);
      shown.curves.push_back(std::move(curve));
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

}  // namespace

Expected<void> reproduce(const ReproduceArguments& options) {
  if (!options.experiment) {
    if (options.pictures) return wanted({"--pictures", *options.pictures}, "an EXPERIMENT as well");
    if (options.keys) return wanted({"--keys", *options.keys}, "an EXPERIMENT as well");
    if (options.report.path) return wanted({"--report", *options.report.path}, "an EXPERIMENT as well");
    return print_document(options.json ? json_of(experiments()) : text_of(experiments()));
  }
  if (options.pictures && options.pictures->empty()) return wanted({"--pictures", ""}, "a folder");
  if (auto checked = check_report(options.report, {{"--keys", options.keys.value_or("")}}); !checked) return checked;
  auto selected = chosen(*options.experiment);
  if (!selected) return tl::unexpected(std::move(selected.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto reports = run_on(std::move(*selected), options.keys);
  if (!reports) return tl::unexpected(std::move(reports.error()));
  if (auto checked = check_motions(*reports, options.report); !checked) return checked;
  if (options.pictures)
    if (auto written = write_pictures(*reports, *options.pictures); !written) return written;
  return print_document(options.json ? json_of(*reports) : text_of(*reports)).and_then([&] {
    return write_page(std::move(*page), std::move(*reports));
  });
}

}  // namespace orispline::cli
