// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fewest keys of a recording within a tolerance (ORISPLINE_OPTIMISE).

#include <orispline/reduce/reduce.hpp>
