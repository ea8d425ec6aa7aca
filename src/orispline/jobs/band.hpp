// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/smooth/smoothed_band.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// Where the true motion may be beside a curve: as the keys of `measured` tell it by themselves, or as smooth() found
/// it for keys that carry what it found.
using Band = std::variant<BandInStretches, SmoothedBand>;

/// The angle about the curve at time t [s] that is meant to hold the share of the true motion; NaN in gaps, infinite
/// where the keys say nothing. [rad]
[[nodiscard]] inline double band_at(const Band& band, double t) noexcept {
  return std::visit([t](const auto& of_kind) { return of_kind(t); }, band);
}

/// The band of the curve of a method through keys. Errors: bad_argument, of `band`, for a curve that has none and for a
/// share that is not between 0 and 1; bad_data, with the key, for what is no standard deviation.
[[nodiscard]] ORISPLINE_EXPORT Expected<Band> band_of(const Track& keys, const Method& method, double share);

}}}  // namespace orispline::jobs
