// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/math/eigen.hpp>

namespace orispline {

/// The rates with which a curve leaves every key and arrives at it [1/s]: three times its Bézier handles per step.
struct HandleRates {
  std::vector<Eigen::Vector3d> leaving, arriving;
};

}  // namespace orispline
