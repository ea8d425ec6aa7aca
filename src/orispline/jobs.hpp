// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tasks as every binding runs them: a request goes in, an outcome comes out with what there is to say of it
// (ORISPLINE_OPTIMISE).

#include <orispline/jobs/align.hpp>
#include <orispline/jobs/align_rates.hpp>
#include <orispline/jobs/bake.hpp>
#include <orispline/jobs/band.hpp>
#include <orispline/jobs/clip.hpp>
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/curve_clip.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/difference.hpp>
#include <orispline/jobs/inspect.hpp>
#include <orispline/jobs/inspect_scene.hpp>
#include <orispline/jobs/mean.hpp>
#include <orispline/jobs/plot.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/jobs/sample.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/jobs/task_list.hpp>
#include <orispline/jobs/tune.hpp>
