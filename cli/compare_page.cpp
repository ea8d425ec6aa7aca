// SPDX-License-Identifier: Apache-2.0
#include "compare_page.hpp"

#include <algorithm>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <orispline/base/version.hpp>
#include <orispline/batch/parallel.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/report/page_samples.hpp>

namespace orispline::cli {
namespace {

constexpr std::size_t samples_per_method = 600;

/// The id of a measure on another set of keys than the first.
std::string id_on(std::string_view id, std::size_t key_set) {
  return key_set == 0 ? std::string(id) : fmt::format("{}_{}", id, key_set);
}

/// On further sets of keys only what a method is chosen by.
bool is_in_page(const CompareFigure& figure, std::size_t key_set) {
  return key_set == 0 || figure.id == "rms_deg" || figure.id == "max_deg";
}

std::vector<report::PageColumn> columns_of(const CompareReport& report) {
  std::vector<report::PageColumn> columns;
  const auto figures = compare_figures(report);
  for (std::size_t i = 0; i < report.data.key_sets.size(); ++i)
    for (const CompareFigure& figure : figures) {
      if (!is_in_page(figure, i) || figure.id == "continuity") continue;  // which has a column of its own
      const auto& decimation = report.data.key_sets[i].decimation;
      const std::string keys = i == 0 || !decimation ? "" : fmt::format(", {}", name_of(*decimation));
      columns.push_back({id_on(figure.id, i), std::string(figure.label) + keys, std::string(figure.unit),
                         std::string(figure.explanation) + keys, figure.better});
    }
  return columns;
}

report::PageMethod method_of(const ComparedMethod& method, const ComparedData& data, const report::PagePath& truth) {
  report::PageMethod result{.name = method.label};
  if (!method.measures) {
    result.failure = describe(method.measures.error());
    return result;
  }
  result.continuity = fmt::format("C{}", method.measures->continuity.order());
  const auto curve =
      make_pose_curve(method.candidate.method, data.key_sets[method.key_set].keys, method.candidate.options);
  if (!curve) return result;  // it was made before
  result.samples = report::sampled(*curve, samples_per_method);
  result.samples.errors = report::errors_to(truth, result.samples.path);
  return result;
}

void add_measures(report::PageMethod& method, const CompareReport& report, const std::vector<CompareFigure>& figures) {
  for (const ComparedMethod& compared : report.methods) {
    if (compared.label != method.name || !compared.measures) continue;
    for (const CompareFigure& figure : figures)
      if (const auto value = figure.value(*compared.measures, report.data);
          value && is_in_page(figure, compared.key_set))
        method.measures.emplace(id_on(figure.id, compared.key_set), *value);
  }
}

std::string now() { return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::time(nullptr))); }

std::string id_of_word(const std::vector<CompareFigure>& figures, std::string_view word) {
  const auto found = std::ranges::find(figures, word, &CompareFigure::word);
  return found == figures.end() || found->id == "continuity" ? "" : std::string(found->id);
}

}  // namespace

report::Page page_of(const CompareReport& report, const std::string& command_line, std::size_t threads) {
  const KeySet& keys = report.data.key_sets.front();
  const auto orientations = report.data.samples.orientations();
  const report::PagePath truth{report.data.times, {orientations.begin(), orientations.end()}};
  const auto figures = compare_figures(report);
  report::Page page{.title = title_of(report, keys),
                    .command = command_line,
                    .date = now(),
                    .version = std::string(version),
                    .time_start = report.data.epoch.to_string(),
                    .keys = report::page_keys(keys.keys),
                    .reference = report::thinned(truth, samples_per_method),
                    .columns = columns_of(report),
                    .sorted_by = id_of_word(figures, report.sort)};
  const auto in_page = static_cast<std::size_t>(
      std::ranges::count(report.methods, std::size_t{0}, &ComparedMethod::key_set));  // they stand first
  page.methods.resize(in_page);
  parallel_for(in_page, static_cast<unsigned>(threads), [&](std::size_t i) {
    page.methods[i] = method_of(report.methods[i], report.data, truth);
    add_measures(page.methods[i], report, figures);
  });
  return page;
}

}  // namespace orispline::cli
