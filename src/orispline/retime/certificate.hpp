// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/retime/motion_limits.hpp>
#include <orispline/retime/rate_bounds.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A limited quantity at the segment where its bound is largest. Values are in the units of the library.
struct ORISPLINE_EXPORT Certificate {
  std::string name;            ///< `rate`, `linear acceleration`, of a component `rate about x`
  std::string id;              ///< `rate`, `linear_acceleration`, `rate_x`
  Unit shown, in_ids;          ///< the unit that was stated, else `°/s`; that of the ids, `deg_s`
  double limit, bound, found;  ///< rad/s and the like, as the times
  double time;                 ///< of `found` [s]
  std::size_t segment;

  /// `rate_bound_deg_s`
  [[nodiscard]] std::string id_of(std::string_view part) const;
  /// A value with its unit, `90 °/s`.
  [[nodiscard]] std::string text_of(double value) const;
};

/// One for each of quantities_of(limits). Precondition: one segment at least.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Certificate> certificates_of(const MotionLimits& limits,
                                                                        std::span<const SegmentPeaks> peaks);

}}  // namespace orispline
