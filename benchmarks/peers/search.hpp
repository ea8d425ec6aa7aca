// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace orispline::bench {

/// The segment of a time and the place in it, from 0 to 1, as most code does it.
struct Place {
  std::size_t segment;
  double u;
};

[[nodiscard]] inline Place place_in(const std::vector<double>& times, double t, std::size_t segment) noexcept {
  return {segment, (t - times[segment]) / (times[segment + 1] - times[segment])};
}

[[nodiscard]] inline Place search(const std::vector<double>& times, double t) noexcept {
  const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
  return place_in(times, t, std::min(after == 0 ? 0 : after - 1, times.size() - 2));
}

}  // namespace orispline::bench
