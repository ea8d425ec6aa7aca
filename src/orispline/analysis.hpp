// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a curve is worth: distances, energies, continuity, peaks, and methods compared by them.

#include <orispline/analysis/compared_keys.hpp>
#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/analysis/key_statistics.hpp>
#include <orispline/analysis/measure_info.hpp>
#include <orispline/curve/motion.hpp>
