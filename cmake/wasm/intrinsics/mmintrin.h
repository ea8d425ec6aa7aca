// SPDX-License-Identifier: Apache-2.0
// Nothing of MMX is used.
#pragma once
