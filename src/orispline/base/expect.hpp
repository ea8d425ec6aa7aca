// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

/// Precondition of a function that never fails otherwise: aborts with text in debug builds, costs nothing in release.
#ifdef NDEBUG
#define ORISPLINE_EXPECT(condition) static_cast<void>(0)
#else
#define ORISPLINE_EXPECT(condition) \
  ((condition)                      \
       ? static_cast<void>(0)       \
       : (std::fprintf(stderr, "%s:%d: precondition failed: %s\n", __FILE__, __LINE__, #condition), std::abort()))
#endif
