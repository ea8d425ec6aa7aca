// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// The frame in which angular rates are stated. Positions and their rates are always in the world frame.
enum class Frame { body, world };

/// What the orientations of a file turn into what.
enum class Turning { body_to_world, world_to_body };

}}}  // namespace orispline::io
