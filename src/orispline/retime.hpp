// SPDX-License-Identifier: Apache-2.0
#pragma once

// The shortest motion within limits of rate, acceleration and torque (ORISPLINE_OPTIMISE).

#include <orispline/retime/retime.hpp>
