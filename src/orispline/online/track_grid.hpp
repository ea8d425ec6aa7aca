// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace orispline {

/// The times of the samples of a track: sample k at k * step + start, computed as written.
struct TrackGrid {
  double step = 0.01;             ///< [s], greater than 0
  std::optional<double> start{};  ///< [s]; absent: where the first curve begins

  /// More samples than that cannot be told apart by a double.
  static constexpr double most_samples = 9e15;
};

/// A grid whose start is known.
class TrackClock {
 public:
  TrackClock(double start, double step) noexcept : start_(start), step_(step) {}
  [[nodiscard]] double operator()(std::uint64_t k) const noexcept { return static_cast<double>(k) * step_ + start_; }
  /// The first sample at that time or later.
  [[nodiscard]] std::uint64_t first_from(double t) const noexcept {
    return first_that(t, [t](double time) { return time >= t; });
  }
  /// The first sample later than that time.
  [[nodiscard]] std::uint64_t first_after(double t) const noexcept {
    return first_that(t, [t](double time) { return time > t; });
  }

 private:
  template <class Reached>
  [[nodiscard]] std::uint64_t first_that(double t, Reached reached) const noexcept {
    // Nearly always it is the one that division names, or the next; many have one time where steps are lost in
    // rounding.
    std::uint64_t low = 0, high = static_cast<std::uint64_t>(TrackGrid::most_samples);
    const double guess = std::clamp(std::floor((t - start_) / step_), 0.0, TrackGrid::most_samples - 1.0);
    for (auto k = static_cast<std::uint64_t>(guess); k <= static_cast<std::uint64_t>(guess) + 1; ++k)
      if (reached((*this)(k))) high = std::min(high, k);
      else low = std::max(low, k + 1);
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      if (reached((*this)(middle))) high = middle;
      else low = middle + 1;
    }
    return low;
  }

  double start_, step_;
};

}  // namespace orispline
