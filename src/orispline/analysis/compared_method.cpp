// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/compared_method.hpp>

#include <algorithm>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Rising from the best; infinite where nothing can be said.
double rank_of(const ComparedMethod& method, const MeasureInfo& measure, const MeasureTimes& times) {
  constexpr double last = std::numeric_limits<double>::infinity();
  if (!method.measures || !measure.is_finite(*method.measures)) return last;
  const double value = measure.value(*method.measures, times).value_or(last);
  return measure.better == Better::more ? -value : value;
}

}  // namespace

void sort_by(const MeasureInfo& measure, std::vector<ComparedMethod>& methods, const MeasureTimes& times) {
  std::ranges::stable_sort(methods, [&](const ComparedMethod& a, const ComparedMethod& b) {
    if (a.key_set != b.key_set) return a.key_set < b.key_set;
    if (a.measures.has_value() != b.measures.has_value()) return a.measures.has_value();
    return rank_of(a, measure, times) < rank_of(b, measure, times);
  });
}

}}  // namespace orispline
