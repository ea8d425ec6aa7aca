// SPDX-License-Identifier: Apache-2.0
#pragma once

#define SIMDE_ENABLE_NATIVE_ALIASES
#define SIMDE_NO_NATIVE
#include <simde/x86/sse.h>
