// SPDX-License-Identifier: Apache-2.0
// A module is what is linked: the C interface, as far as its functions are named.
#include "orispline.h"
