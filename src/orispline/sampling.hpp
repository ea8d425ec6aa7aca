// SPDX-License-Identifier: Apache-2.0
#pragma once

// Many samples at once: of a curve, of a compiled or baked one, of many curves.

#include <orispline/base/parallel.hpp>
#include <orispline/batch/baked_curve.hpp>
#include <orispline/batch/baked_motion.hpp>
#include <orispline/batch/baked_path.hpp>
#include <orispline/batch/compiled_curve.hpp>
#include <orispline/batch/curve_bundle.hpp>
#include <orispline/batch/kernel/dispatch.hpp>
#include <orispline/batch/pose_sampler.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/batch/sample_grid.hpp>
