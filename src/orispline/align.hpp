// SPDX-License-Identifier: Apache-2.0
#pragma once

// One recording brought onto another one of the same motion, of orientations or of a gyro (ORISPLINE_OPTIMISE).

#include <orispline/align/align.hpp>
#include <orispline/align/rate_alignment.hpp>
