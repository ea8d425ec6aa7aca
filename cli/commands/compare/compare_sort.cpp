// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_report.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {
namespace {

constexpr std::string_view rate_word = "rate";

}  // namespace

std::string sort_words() {
  std::string words;
  for (const MeasureInfo& measure : measures_info())
    if (!measure.word.empty()) words.append(words.empty() ? "" : "|").append(measure.word);
  return words;
}

Expected<std::string> sort_word_in(OptionText option) {
  const std::string words = sort_words();
  const auto known = pieces_of(words, '|');
  if (std::ranges::find(known, option.text) == known.end()) return wanted(option, words);
  return std::string(option.text);
}

Expected<void> sort(CompareReport& report) {
  const auto measures = measures_of(report);
  const auto measure = std::ranges::find(measures, report.sort, &MeasureInfo::word);
  if (measure == measures.end())
    return usage_failure(formatted(
        "--sort {}: wanted {}", report.sort,
        report.sort == rate_word ? "columns wx,wy,wz in " + report.data.reference : std::string("--inertia as well")));
  sort_by(*measure, report.methods, report.data.measure_times());
  return {};
}

}  // namespace orispline::cli
