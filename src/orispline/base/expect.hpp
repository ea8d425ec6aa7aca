// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

/// Precondition of a function that never fails otherwise: where it is not met the program aborts with its text. None of
/// them stands in an inner loop, so that releases have them too, and what is tested is what is shipped.
#define ORISPLINE_EXPECT(condition)                                                                               \
  ((condition) ? static_cast<void>(0)                                                                             \
               : (std::fprintf(stderr, "%s, line %d: precondition failed: %s\n", __func__, __LINE__, #condition), \
                  std::abort()))
