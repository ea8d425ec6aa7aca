// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/blending/rows.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// What the rows promise, decided at random parameters and lengths: in fractions modulo two primes, so that it holds
/// for all of them, and in doubles whose errors are bounded, since fractions do not tell powers near 2^61 from others.
/// In the order of the promises.
[[nodiscard]] std::vector<BlendingFinding> findings_of(const BlendingData& data, const Rows& rows);

/// Whether the body rests at a key where that parameter is 0.
[[nodiscard]] bool rests_at_zero(const BlendingData& data, const Rows& rows, std::size_t parameter);

}}}  // namespace orispline::blending
