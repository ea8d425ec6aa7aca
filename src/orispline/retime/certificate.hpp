// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/retime/motion_limits.hpp>
#include <orispline/retime/rate_bounds.hpp>

namespace orispline::inline ORISPLINE_ABI {

/// A limited quantity in the units that are shown, at the segment where its bound is largest.
struct ORISPLINE_EXPORT Certificate {
  std::string_view name, unit, unit_in_ids;  ///< `rate`, `°/s`, `deg_s`
  double limit, bound, found;                ///< in that unit
  double time;                               ///< of `found` [s]
  std::size_t segment;

  /// `rate_bound_deg_s`
  [[nodiscard]] std::string id_of(std::string_view part) const;
};

/// One for each of the limits. Precondition: one segment at least.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Certificate> certificates_of(const MotionLimits& limits,
                                                                        std::span<const SegmentPeaks> peaks);

}  // namespace orispline::inline ORISPLINE_ABI
