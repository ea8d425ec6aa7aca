// SPDX-License-Identifier: Apache-2.0
#pragma once

// The best tensions of a method (ORISPLINE_OPTIMISE).

#include <orispline/tune/tune.hpp>
