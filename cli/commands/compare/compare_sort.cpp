// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_report.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

std::string sort_words() {
  std::string words;
  for (const MeasureInfo& measure : measures_info())
    if (!measure.word.empty()) words.append(words.empty() ? "" : "|").append(measure.word);
  return words;
}

Expected<std::string> sort_word_in(OptionText option) {
  return measure_of_word(option.text).map([](const MeasureInfo& measure) { return std::string(measure.word); });
}

bool is_torque(std::string_view word) {
  const auto measure = std::ranges::find(measures_info(), word, &MeasureInfo::word);
  return measure != measures_info().end() && measure->group == MeasureGroup::torque;
}

Expected<void> sort(CompareReport& report) {
  const auto measures = measures_of(report);
  const auto measure = std::ranges::find(measures, report.sort, &MeasureInfo::word);
  if (measure == measures.end())
    return usage_failure(formatted("--sort {}: wanted columns wx,wy,wz in {}", report.sort, report.data.reference));
  sort_by(*measure, report.methods, report.data.measure_times());
  return {};
}

}  // namespace orispline::cli
