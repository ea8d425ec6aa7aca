// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/report/sphere.hpp>

namespace orispline::cli {

/// Of edge length 1.2, its three pairs of sides in three shades.
[[nodiscard]] std::vector<report::Face> cube();

/// A cup of height 1.2 that stands along the body's z axis, the handle along x.
[[nodiscard]] std::vector<report::Face> cup();

}  // namespace orispline::cli
