// SPDX-License-Identifier: Apache-2.0
#pragma once

// Results as SVG: charts, and paths on the sphere.

#include <orispline/report/chart.hpp>
#include <orispline/report/motion_drawing.hpp>
#include <orispline/report/page_samples.hpp>
#include <orispline/report/sphere.hpp>
#include <orispline/report/svg.hpp>
#include <orispline/report/table.hpp>
