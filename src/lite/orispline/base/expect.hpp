// SPDX-License-Identifier: Apache-2.0
#pragma once

// In the place of the header of that name where a program is to be small.

/// Precondition of a function that never fails otherwise: where it is not met the program ends, without a text.
#define ORISPLINE_EXPECT(condition) ((condition) ? static_cast<void>(0) : __builtin_trap())
