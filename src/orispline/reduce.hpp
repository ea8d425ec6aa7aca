// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fewest keys of a recording, or of the clips of a skeleton, within a tolerance (ORISPLINE_OPTIMISE).

#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>
