// SPDX-License-Identifier: Apache-2.0
#pragma once

// One recording brought onto another one of the same motion (ORISPLINE_OPTIMISE).

#include <orispline/align/align.hpp>
