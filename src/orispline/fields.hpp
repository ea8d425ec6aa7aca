// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options and results of the tasks as data, for faces that are made from them (ORISPLINE_OPTIMISE).

#include <orispline/analysis/comparison_fields.hpp>
#include <orispline/fields/typed_field.hpp>
#include <orispline/reduce/reduce_fields.hpp>
#include <orispline/retime/retime_fields.hpp>
#include <orispline/smooth/smooth_fields.hpp>
#include <orispline/tune/tune_fields.hpp>
