// SPDX-License-Identifier: Apache-2.0
#pragma once

// The mean and the median of many orientations (ORISPLINE_OPTIMISE).

#include <orispline/mean/mean.hpp>
