// SPDX-License-Identifier: Apache-2.0
#pragma once

// Results as pages to look at in a browser (ORISPLINE_PAGE).

#include <orispline/pages/compare_page.hpp>
#include <orispline/pages/curve_page.hpp>
#include <orispline/pages/motion_page.hpp>
#include <orispline/pages/reduce_page.hpp>
#include <orispline/pages/retime_page.hpp>
#include <orispline/pages/skeleton_page.hpp>
#include <orispline/pages/smooth_page.hpp>
