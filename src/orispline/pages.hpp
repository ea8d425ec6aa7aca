// SPDX-License-Identifier: Apache-2.0
#pragma once

// Results as pages to look at in a browser (ORISPLINE_PAGE).

#include <orispline/pages/task_pages.hpp>
