// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/witness_samples.hpp>

#include <algorithm>
#include <bit>

namespace orispline { inline namespace ORISPLINE_ABI {

WitnessSamples::WitnessSamples(const SpanTest& spans, std::size_t size) : size_(size) {
  for (std::size_t intervals = 2; intervals < size; intervals *= 2) {
    std::vector<std::size_t> level;
    for (std::size_t first = 0; first + intervals < size; first += intervals) {
      const std::vector<std::size_t> samples = spans.farthest_from_block(first, intervals, 4);
      level.insert(level.end(), samples.begin(), samples.end());
    }
    std::ranges::sort(level);
    levels_.push_back(std::move(level));
  }
}

const std::vector<std::size_t>* WitnessSamples::at_distance(std::size_t distance) const {
  const auto width = static_cast<std::size_t>(std::bit_width(distance));
  return width < 4 || levels_.empty() ? nullptr : &levels_[std::min(width - 4, levels_.size() - 1)];
}

std::size_t WitnessSamples::after(std::size_t i, std::size_t looked) const {
  const auto* samples = at_distance(looked - i);
  if (!samples) return std::min(looked + 1, size_ - 1);
  const auto next = std::ranges::upper_bound(*samples, looked);
  return next == samples->end() ? size_ - 1 : *next;
}

std::size_t WitnessSamples::before(std::size_t i, std::size_t looked) const {
  const auto* samples = at_distance(i - looked);
  if (!samples) return std::max<std::size_t>(looked, 1) - 1;
  const auto next = std::ranges::lower_bound(*samples, looked);
  return next == samples->begin() ? 0 : *(next - 1);
}

}}  // namespace orispline
