// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace orispline::bench {

/// What multiplies the three half-angle vectors of a segment after its first key, in u from 0 to 1, by the tensions of
/// its two keys.
///
/// Source: Tan, Xing, Fan & Hong 2018, (3.2) and (3.6), less the whole first factor that leads to the segment's key.
template <class T>
[[nodiscard]] inline std::array<T, 3> quintic_blending(T u, T tension, T next_tension) noexcept {
  const T v = T(1) - u, u2 = u * u, v2 = v * v;
  const T b1 = 5 * u * v2 * v2, b2 = 10 * u2 * v2 * v, b3 = 10 * u2 * u * v2, b4 = 5 * u2 * u2 * v, b5 = u2 * u2 * u;
  const T a = tension / 20, b = next_tension / 20;
  const T last = -(7 * b * b3 + 4 * b * b4);
  return {4 * a * b1 + 7 * a * b2, 4 * a * b1 + 9 * a * b2 + (1 - 2 * b) * b3 + b4 + b5 + last, last};
}

}  // namespace orispline::bench
