// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options and results of the tasks as data, for bindings that are made from them (ORISPLINE_OPTIMISE).

#include <orispline/align/align.hpp>
#include <orispline/align/rate_alignment.hpp>
#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/edit/clip_edits.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/mean/mean.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/retime/retime.hpp>
#include <orispline/smooth/smooth.hpp>
#include <orispline/tune/tune.hpp>
