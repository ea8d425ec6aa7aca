// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/smooth/smooth.hpp>

#include "output/json_document.hpp"

namespace orispline::cli {

/// Samples with their lines and times in the file.
[[nodiscard]] Json places_json(const std::vector<std::size_t>& samples, const std::vector<std::uint32_t>& lines,
                               const std::vector<Decimal>& times);

/// `gcv`, `ubre`, `reml`; null where the smoothing time was stated.
[[nodiscard]] Json criterion_of(const orispline::Smoothing& smoothing);

}  // namespace orispline::cli
