// SPDX-License-Identifier: Apache-2.0
#pragma once

// A noisy recording as a smooth motion (ORISPLINE_OPTIMISE).

#include <orispline/smooth/smooth.hpp>
#include <orispline/smooth/smoothed_band.hpp>
