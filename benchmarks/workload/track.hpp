// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orispline::bench {

/// Keys as plain numbers: what every contender is given. Contenders may be compiled for other instruction sets than the
/// library, so that types whose layout depends on them must not pass between.
struct Track {
  std::vector<double> times;         ///< [s], uneven
  std::vector<double> orientations;  ///< unit, neighbours on one hemisphere; qx, qy, qz, qw key after key
  std::vector<double> tensions;      ///< one per key

  [[nodiscard]] std::size_t keys() const noexcept { return times.size(); }
  [[nodiscard]] double duration() const noexcept { return times.back() - times.front(); }
};

/// Random axes, half angles from key to key of 0.05 to 1.2 rad, steps of 0.6 to 1.4 s, tensions of 0.35 to 0.65.
[[nodiscard]] Track random_track(std::size_t keys, std::uint64_t seed);

/// Sample times from the first key to the last: k * dt + t0.
struct EvenTimes {
  double t0, dt;
  std::size_t count;

  [[nodiscard]] double operator[](std::size_t k) const noexcept { return static_cast<double>(k) * dt + t0; }
  [[nodiscard]] std::vector<double> all() const;
};
[[nodiscard]] EvenTimes even_times(const Track& track, std::size_t count);

/// Times in no order.
[[nodiscard]] std::vector<double> random_times(const Track& track, std::size_t count, std::uint64_t seed);

}  // namespace orispline::bench
