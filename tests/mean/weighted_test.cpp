// SPDX-License-Identifier: Apache-2.0
#include <orispline/mean/weighted.hpp>

#include <gtest/gtest.h>

namespace orispline { namespace {

TEST(VectorSum, LosesNothingBesideLargeTerms) {
  mean_of::VectorSum sum;
  for (const double x : {1.0, 1e100, 1.0, -1e100}) sum.add(Eigen::Vector3d(x, -x, 0.5 * x));
  EXPECT_EQ(sum.value(), Eigen::Vector3d(2.0, -2.0, 1.0));
}

}}  // namespace orispline
