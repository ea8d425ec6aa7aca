// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/measure_info.hpp>

#include <algorithm>
#include <iterator>

#include <orispline/base/suggestion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Expected<MeasureInfo> measure_of_word(std::string_view word) {
  std::vector<std::string_view> words;
  for (const MeasureInfo& measure : measures_info()) {
    if (!measure.word.empty() && measure.word == word) return measure;
    if (!measure.word.empty()) words.push_back(measure.word);
  }
  return bad_option("sort", unknown_word("measure", word, words));
}

std::vector<MeasureInfo> measures_of(std::span<const MeasureGroup> groups) {
  std::vector<MeasureInfo> measures;
  std::ranges::copy_if(measures_info(), std::back_inserter(measures), [&](const MeasureInfo& measure) {
    return std::ranges::find(groups, measure.group) != groups.end();
  });
  return measures;
}

std::vector<MeasureInfo> measures_of(std::initializer_list<MeasureGroup> groups) {
  return measures_of(std::span(groups.begin(), groups.size()));
}

}}  // namespace orispline
