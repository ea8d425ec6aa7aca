// SPDX-License-Identifier: Apache-2.0
#include <orispline/mean/mean.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

template <class T>
std::span<const T> part_of(std::span<const T> list, std::size_t first, std::size_t count) {
  return list.empty() ? list : list.subspan(first, count);
}

bool counts_for_nothing(std::span<const double> weights) {
  return !weights.empty() && std::ranges::all_of(weights, [](double weight) { return weight == 0.0; });
}

/// The mean of successive entries, with places among all.
Expected<Mean> mean_of_part(const OrientationSet& given, std::size_t first, std::size_t count,
                            const MeanOptions& options) {
  auto found = mean({part_of(given.orientations, first, count), part_of(given.positions, first, count),
                     part_of(given.weights, first, count)},
                    options);
  if (!found) {
    found.error().where.key = first + found.error().where.key.value_or(0);
    return found;
  }
  found->farthest += first;
  if (found->farthest_position) *found->farthest_position += first;
  for (Warning& warning : found->warnings) warning.where.key = first;
  return found;
}

}  // namespace

Expected<void> check(const MeanOptions& options) { return check_ranges(options); }

Expected<std::vector<MeanWindow>> mean_in_windows(std::span<const double> times, const OrientationSet& given,
                                                  const MeanOptions& options) {
  if (times.size() != given.orientations.size())
    return failure(ErrorCode::bad_data, formatted("found {} of {}, wanted one of each", counted(times.size(), "time"),
                                                  counted(given.orientations.size(), "orientation")));
  if (auto checked = check(options); !checked) return tl::unexpected(std::move(checked.error()));
  std::vector<MeanWindow> windows;
  if (!options.every || times.empty())
    return mean(given, options).map([&](Mean found) {
      windows.push_back({0.5 * (times.front() + times.back()), 0, std::move(found)});
      return std::move(windows);
    });
  const auto window_of = [&](std::size_t i) { return std::floor((times[i] - times.front()) / *options.every); };
  for (std::size_t first = 0, end = 0; first < times.size(); first = end) {
    const double window = window_of(first);
    while (end < times.size() && window_of(end) == window) ++end;
    if (counts_for_nothing(part_of(given.weights, first, end - first))) continue;
    auto found = mean_of_part(given, first, end - first, options);
    if (!found) return tl::unexpected(std::move(found.error()));
    windows.push_back({times.front() + (window + 0.5) * *options.every, first, std::move(*found)});
  }
  if (windows.empty()) return tl::unexpected(mean(given, options).error());
  return windows;
}

}}  // namespace orispline
