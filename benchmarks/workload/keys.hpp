// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/orispline.hpp>
#include <string_view>
#include <workload/track.hpp>

namespace orispline::bench {

[[nodiscard]] Keyframes keys_of(const Track& track);

/// The track with the orientations that the library makes of its keys, so that all contenders have the same to a bit.
[[nodiscard]] Track normalised(Track track);

/// The curve of a method through the track's keys; of the quintic one with the track's tensions.
[[nodiscard]] AnyCurve curve_through(const Track& track, std::string_view method = "quintic");

/// Ends the program with the error: a benchmark has nothing else to do with it.
[[noreturn]] void give_up(std::string_view reason);

template <class T>
[[nodiscard]] T value_or_give_up(Expected<T> expected) {
  if (!expected) give_up(describe(expected.error()));
  return std::move(*expected);
}
inline void check(const Expected<void>& expected) {
  if (!expected) give_up(describe(expected.error()));
}

}  // namespace orispline::bench
