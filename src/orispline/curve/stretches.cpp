// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/stretches.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/math/median.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double time_rounding = 1e-6;  // relative, of intervals

}  // namespace

Expected<std::vector<Stretch>> stretches_between_gaps(std::span<const double> times, std::optional<double> gap) {
  if (const double interval = gap ? median_interval(times) : 0.0; gap && !(*gap > interval * (1.0 + time_rounding)))
    return bad_option("gap",
                      formatted("found {:.6g} s, wanted more than the median interval of {:.6g} s", *gap, interval));
  std::vector<Stretch> stretches{{0, 1}};
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] == times[i - 1] || (gap && times[i] - times[i - 1] > *gap)) stretches.push_back({i, 1});
    else ++stretches.back().count;
  return stretches;
}

}}  // namespace orispline
