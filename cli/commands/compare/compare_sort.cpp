// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_report.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace orispline::cli {
namespace {

constexpr std::string_view rate_word = "rate", torque_word = "torque";

/// Rising from the best; infinite where nothing can be said.
double rank_of(const ComparedMethod& method, const CompareFigure& figure, const ComparedData& data) {
  constexpr double last = std::numeric_limits<double>::infinity();
  if (!method.measures || !is_finite(figure, *method.measures)) return last;
  const double value = figure.value(*method.measures, data).value_or(last);
  return figure.better == report::Better::more ? -value : value;
}

}  // namespace

bool is_finite(const CompareFigure& figure, const Measures& measures) {
  const int order = figure.word == "energy" || figure.word == torque_word ? 1 : figure.word == "jerk" ? 2 : 0;
  return measures.continuity.order() >= order;
}

std::string sort_words() {
  std::string words;
  for (const CompareFigure& figure : all_compare_figures())
    if (!figure.word.empty()) words.append(words.empty() ? "" : "|").append(figure.word);
  return words;
}

Expected<std::string> sort_word_in(OptionText option) {
  const std::string words = sort_words();
  const auto known = pieces_of(words, '|');
  if (std::ranges::find(known, option.text) == known.end()) return wanted(option, words);
  return std::string(option.text);
}

Expected<void> sort(CompareReport& report) {
  const auto figures = compare_figures(report);
  const auto figure = std::ranges::find(figures, report.sort, &CompareFigure::word);
  if (figure == figures.end())
    return usage_failure(fmt::format(
        "--sort {}: wanted {}", report.sort,
        report.sort == rate_word ? "columns wx,wy,wz in " + report.data.reference : std::string("--inertia as well")));
  std::ranges::stable_sort(report.methods, [&](const ComparedMethod& a, const ComparedMethod& b) {
    if (a.key_set != b.key_set) return a.key_set < b.key_set;
    if (a.measures.has_value() != b.measures.has_value()) return a.measures.has_value();
    return rank_of(a, *figure, report.data) < rank_of(b, *figure, report.data);
  });
  return {};
}

}  // namespace orispline::cli
