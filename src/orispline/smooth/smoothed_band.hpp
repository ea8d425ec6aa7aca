// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/stretches.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Writes what the curve through smoothed keys needs of these deviations into their settings: `band_columns`.
/// Precondition: one entry per key.
void set_band(Track& keys, const NodeSigmas& sigmas);

/// Where the true motion may be: the angle about the curve through smoothed keys that is meant to hold a share of it.
///
/// The standard deviation per axis is that of the posterior of smooth(), which keys carry in `band_columns`; a turn
/// with it about each axis is within the angle with the probability of the share. Between the sixths of a step its
/// square is a polynomial of degree six, which for the penalty of the acceleration is exact. Our own derivation,
/// docs/smooth.md.
class ORISPLINE_EXPORT SmoothedBand {
 public:
  /// Whether the keys carry it, and the method makes the curve that it is about.
  [[nodiscard]] static bool is_of(const Track& keys, const Method& method);

  /// Precondition: `is_of(keys, method)`. Errors: bad_argument for a share that is not between 0 and 1; bad_data, with
  /// the key, for a deviation that is negative or not finite; those of stretches_between_gaps().
  [[nodiscard]] static Expected<SmoothedBand> make(const Track& keys, double share);

  /// At time t [s]; before the first key and after the last the end's, NaN in gaps. [rad] Allocates nothing.
  [[nodiscard]] double operator()(double t) const noexcept;

 private:
  SmoothedBand() = default;

  std::vector<double> times_;
  std::vector<std::array<double, band_columns.size()>> variances_;  ///< per axis, at the sixths from each key [rad²]
  std::vector<bool> ends_;                                          ///< whether a gap begins behind the key
  double radius_ = 0.0;                                             ///< in standard deviations
};

}}  // namespace orispline
