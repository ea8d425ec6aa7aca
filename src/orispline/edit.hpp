// SPDX-License-Identifier: Apache-2.0
#pragma once

// Clips of a skeleton cut, turned round, made faster and closed into loops (ORISPLINE_OPTIMISE).

#include <orispline/edit/clip_edits.hpp>
#include <orispline/edit/cut.hpp>
#include <orispline/edit/join.hpp>
#include <orispline/edit/loop.hpp>
#include <orispline/edit/root_motion.hpp>
#include <orispline/edit/seam.hpp>
