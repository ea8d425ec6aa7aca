// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <workload/track.hpp>

namespace orispline::bench {

/// Where a time of the track lies among the segments of a cubic B-spline with the track's keys for control points at
/// even times: segment s blends the keys s … s + 3. In billionths of a segment, which basalt takes for nanoseconds.
[[nodiscard]] inline std::int64_t uniform_place(const Track& track, double t) noexcept {
  const double segments = static_cast<double>(track.keys()) - 3.0;
  const double place = segments * (t - track.times.front()) / track.duration();
  return static_cast<std::int64_t>(std::floor(0.999'999'999 * place * 1e9));
}

}  // namespace orispline::bench
