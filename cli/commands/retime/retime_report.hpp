// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orispline/retime/retime.hpp>

namespace orispline::cli {

/// What `orispline retime` did.
struct RetimeReport {
  std::string input{}, output{};
  orispline::MotionLimits limits{};
  orispline::Slowing slowing{};   ///< that was asked for
  double duration_before = 0.0;  ///< [s]
  orispline::Retiming retiming{};
};

/// A limited quantity in the units that are shown, at the segment where its bound is largest.
struct Certificate {
  std::string_view name, unit, json_unit;
  double limit, bound, found, time;
  std::size_t segment;
};

/// One for each of the limits.
[[nodiscard]] std::vector<Certificate> certificates_of(const orispline::MotionLimits& limits,
                                                       const std::vector<orispline::SegmentPeaks>& peaks);

/// A few lines for people.
[[nodiscard]] std::string text_of(const RetimeReport& report);

/// One JSON document, described in docs/inspect-json.md.
[[nodiscard]] std::string json_of(const RetimeReport& report);

}  // namespace orispline::cli
