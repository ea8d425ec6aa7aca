// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace orispline::io {

/// The frame in which angular rates are stated. Positions and their rates are always in the world frame.
enum class Frame { body, world };

}  // namespace orispline::io
