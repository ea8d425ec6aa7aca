// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <orispline/base/parallel.hpp>

#include "output/report_page.hpp"

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
  for (std::size_t i = 0; i < report.data.key_sets.size(); ++i) {
    std::vector<CompareFigure> figures = compare_figures(report);
    std::erase_if(figures, [&](const CompareFigure& figure) { return !is_in_page(figure, i); });
    const auto& decimation = report.data.key_sets[i].decimation;
    const std::string keys = i == 0 || !decimation ? "" : fmt::format(", {}", name_of(*decimation));
    for (report::PageColumn& column : columns_of(std::move(figures)))
      columns.push_back(
          {id_on(column.id, i), column.label + keys, column.unit, column.explanation + keys, column.better});
  }
  return columns;
}

report::PageMethod method_of(const ComparedMethod& method, const CompareReport& report, const report::PagePath& truth) {
  report::PageMethod result{.name = method.label};
  if (!method.measures) {
    result.failure = describe(method.measures.error());
    return result;
  }
  result.continuity = fmt::format("C{}", method.measures->continuity.order());
  const auto curve =
      make_pose_curve(method.candidate.method, method.candidate.keys);
  if (!curve) return result;  // it was made before
  result.samples = samples_of(*curve, report.inertia, samples_per_method);
  result.samples.errors = report::errors_to(truth, result.samples.path);
  return result;
}

void add_measures(report::PageMethod& method, const CompareReport& report, const std::vector<CompareFigure>& figures) {
  for (const ComparedMethod& compared : report.methods) {
    if (compared.label != method.name || !compared.measures) continue;
    for (const CompareFigure& figure : figures)
      if (const auto value = figure.value(*compared.measures, report.data);
          value && is_in_page(figure, compared.key_set) && is_finite(figure, *compared.measures))
        method.measures.emplace(id_on(figure.id, compared.key_set), *value);
  }
}

std::string id_of_word(const std::vector<CompareFigure>& figures, std::string_view word) {
  const auto found = std::ranges::find(figures, word, &CompareFigure::word);
  return found == figures.end() || found->id == "continuity" ? "" : std::string(found->id);
}

}  // namespace

report::Page page_of(const CompareReport& report, const ReportOptions& options, std::size_t threads) {
  const ComparedKeys& keys = report.data.key_sets.front();
  const report::PagePath truth = path_of(report.data.times, report.data.samples.orientations());
  const auto figures = compare_figures(report);
  report::Page page = begun_page(title_of(report, keys), options, report.data.epoch, keys.track.keys);
  page.reference = report::thinned(truth, samples_per_method);
  page.columns = columns_of(report);
  page.sorted_by = id_of_word(figures, report.sort);
  const auto in_page = static_cast<std::size_t>(
      std::ranges::count(report.methods, std::size_t{0}, &ComparedMethod::key_set));  // they stand first
  page.methods.resize(in_page);
  parallel_for(in_page, static_cast<unsigned>(threads), [&](std::size_t i) {
    page.methods[i] = method_of(report.methods[i], report, truth);
    add_measures(page.methods[i], report, figures);
  });
  return page;
}

}  // namespace orispline::cli
