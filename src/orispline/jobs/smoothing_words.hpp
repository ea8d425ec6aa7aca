// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/fields/field_json.hpp>
#include <orispline/smooth/smooth.hpp>

// What smoothing a recording and reducing a smoothed one say alike.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// `: line 6 (5.2 s), line 9 (5.8 s)`, some of the samples, with their lines and times in the recording.
[[nodiscard]] std::string places_text(const std::vector<std::size_t>& samples, const Places& places);
[[nodiscard]] std::string places_text(const std::vector<std::size_t>& samples, const Track& recording);

/// `smoothing time  0.1 s (cut-off 1.59 Hz), by …`
[[nodiscard]] std::string choice_line(const Smoothing& smoothing);

/// `positions       smoothing time 0.1 s (cut-off 1.59 Hz), by …`, or that they are as they were; empty without any.
[[nodiscard]] std::string position_choice_line(const Smoothing& smoothing);

}}}  // namespace orispline::jobs
