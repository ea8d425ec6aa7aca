// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A fit, as far as others are judged beside it.
struct TriedOffset {
  double offset, sigma;  ///< of the clocks [s], and how sure it is
  double noise;          ///< what is left, σ per axis
  std::size_t samples;   ///< that were compared
};

/// The best of fits that begin at several offsets, and another offset that is about as good. `Fit` has `cost()` and
/// `tried()`.
template <class Fit>
class BestOfOffsets {
 public:
  void add(std::optional<Fit> fit) {
    if (!fit) return;
    all_.push_back(fit->tried());
    if (!best_ || fit->cost() < best_->cost()) best_ = std::move(fit);
  }

  /// None where the recordings do not overlap.
  [[nodiscard]] const std::optional<Fit>& best() const noexcept { return best_; }

  /// The best of the others that is farther from the best one than an interval [s] and than both are sure, and leaves
  /// no more than chance does. Precondition: there is a best one.
  [[nodiscard]] std::optional<double> rival(double interval) const {
    constexpr double sure = 5.0, by_chance = 3.0;  // standard deviations
    const TriedOffset best = best_->tried();
    const TriedOffset* rival = nullptr;
    for (const TriedOffset& other : all_) {
      const double apart = std::max(interval, sure * (best.sigma + other.sigma));
      const double numbers = 3.0 * static_cast<double>(std::min(best.samples, other.samples));
      const bool is_as_good = other.noise <= best.noise * (1.0 + by_chance / std::sqrt(2.0 * numbers));
      if (std::abs(other.offset - best.offset) <= apart || 2 * other.samples < best.samples || !is_as_good) continue;
      if (!rival || other.noise < rival->noise) rival = &other;
    }
    return rival ? std::optional(rival->offset) : std::nullopt;
  }

 private:
  std::optional<Fit> best_;
  std::vector<TriedOffset> all_;
};

/// The least part of an open direction, which has length 1, that is no rounding.
inline constexpr double told_from = 0.05;

template <class Open>
[[nodiscard]] bool leaves_offset(const Open& open) {
  return std::abs(open.offset) > told_from;
}

/// Of a rival that is so far from the offset that was found [s].
[[nodiscard]] inline Warning ambiguous_offset(double apart) {
  return {
      .code = "ambiguous_offset",
      .message = formatted("an offset of the clocks {:.4g} s away fits about as well: the motion is short or repeats "
                           "itself, wanted a longer one, or `offset` where it is known",
                           std::abs(apart)),
      .numbers = {{"apart_s", std::abs(apart)}}};
}

/// Warns of another offset that is about as good, unless the motion leaves the offset open anyhow.
template <class Found, class Fit>
void warn_of_rival(Found& found, const BestOfOffsets<Fit>& fits, double interval) {
  const auto rival = fits.rival(interval);
  if (!rival || std::ranges::any_of(found.open, [](const auto& open) { return leaves_offset(open); })) return;
  found.warnings.push_back(ambiguous_offset(*rival - fits.best()->tried().offset));
}

}}  // namespace orispline
