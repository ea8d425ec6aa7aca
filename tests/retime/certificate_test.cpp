// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/certificate.hpp>

#include <gtest/gtest.h>

#include <orispline/math/degrees.hpp>

namespace orispline {
namespace {

TEST(Certificate, IsThatOfTheSegmentWithTheLargestBoundInTheUnitsThatAreShown) {
  const std::vector<SegmentPeaks> peaks{{.rate = {.found = 1.0, .bound = 1.1, .time = 0.5}, .torque = {.bound = 7.0}},
                                        {.rate = {.found = 0.9, .bound = 1.2, .time = 1.5}, .torque = {.bound = 6.0}}};
  const auto certificates = certificates_of({.rate = 2.0, .torque = 8.0}, peaks);
  ASSERT_EQ(certificates.size(), 2u);
  EXPECT_EQ(certificates[0].segment, 1u);
  EXPECT_EQ(certificates[0].time, 1.5);
  EXPECT_EQ(certificates[0].limit, 2.0 * degrees);
  EXPECT_EQ(certificates[0].bound, 1.2 * degrees);
  EXPECT_EQ(certificates[0].found, 0.9 * degrees);
  EXPECT_EQ(certificates[0].id_of("bound"), "rate_bound_deg_s");
  EXPECT_EQ(certificates[1].segment, 0u);
  EXPECT_EQ(certificates[1].bound, 7.0);
  EXPECT_EQ(certificates[1].id_of("max"), "torque_max_nm");
}

}  // namespace
}  // namespace orispline
