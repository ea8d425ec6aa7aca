// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Samples that no chain has reached yet, each with the first sample from which a span to it may begin.
class SpanTargets {
 public:
  explicit SpanTargets(const std::vector<std::size_t>& earliest) : leaves_(std::bit_ceil(earliest.size())) {
    earliest_.assign(2 * leaves_, none);
    std::copy(earliest.begin(), earliest.end(), earliest_.begin() + static_cast<std::ptrdiff_t>(leaves_));
    for (std::size_t node = leaves_; node-- > 1;) update(node);
  }

  /// The first one from sample k on to which a span from sample i may go; `none` where there is none.
  [[nodiscard]] std::size_t next(std::size_t i, std::size_t k) const {
    if (k >= leaves_) return none;
    std::size_t node = leaves_ + k;
    while (earliest_[node] > i) {
      while (node % 2 == 1) node /= 2;
      if (node == 0) return none;
      ++node;
    }
    while (node < leaves_) {
      node *= 2;
      if (earliest_[node] > i) ++node;
    }
    return node - leaves_;
  }
  void remove(std::size_t k) {
    earliest_[leaves_ + k] = none;
    for (std::size_t node = (leaves_ + k) / 2; node > 0; node /= 2) update(node);
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

 private:
  void update(std::size_t node) { earliest_[node] = std::min(earliest_[2 * node], earliest_[2 * node + 1]); }

  std::size_t leaves_;
  std::vector<std::size_t> earliest_;  ///< a tree of minima: node n has the children 2n and 2n + 1
};

}}  // namespace orispline
