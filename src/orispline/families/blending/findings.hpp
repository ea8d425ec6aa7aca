// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/blending/rows.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// What the rows promise: decided in the field of Modular at random parameters and lengths, so that it holds for all of
/// them. In the order of the promises.
[[nodiscard]] std::vector<BlendingFinding> findings_of(const BlendingData& data, const Rows& rows);

}}}  // namespace orispline::blending
