// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What the motion between the samples of a recording is taken to be.
enum class BetweenSamples {
  smooth,  ///< the curve `auto` through all samples
  stored   ///< what the channel says: its own interpolation
};

}}  // namespace orispline
