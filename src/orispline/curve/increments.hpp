// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// From each point of a list to the next: n of them give n-1 displacements, rotation vectors [rad] or differences [m].
template <class Points>
[[nodiscard]] auto increments_between(const Points& points) {
  using P = typename Points::value_type;
  std::vector<Displacement<P>> increments;
  increments.reserve(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    increments.push_back(displacement<double>(points[i], points[i + 1]));
  return increments;
}

}}  // namespace orispline
