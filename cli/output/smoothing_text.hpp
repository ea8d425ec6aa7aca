// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orispline/jobs/smoothing_words.hpp>

// For `reduce`, while it is no job.

namespace orispline::cli {

using jobs::choice_line;
using jobs::position_choice_line;
using jobs::remark_on;

[[nodiscard]] inline std::string places_text(const std::vector<std::size_t>& samples,
                                             const std::vector<std::uint32_t>& lines,
                                             const std::vector<Decimal>& times) {
  return jobs::places_text(samples, {lines, [&times](std::size_t sample) { return times[sample]; }});
}

}  // namespace orispline::cli
