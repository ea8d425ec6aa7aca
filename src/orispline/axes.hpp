// SPDX-License-Identifier: Apache-2.0
#pragma once

// Other axes and frames for keys: from NED to ENU, from a camera's axes to those of its body, any fixed rotation.

#include <orispline/curve/frame_change.hpp>
