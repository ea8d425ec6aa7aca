// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <gtest/gtest.h>

#include <orispline/math/degrees.hpp>

namespace orispline { namespace {

TEST(Certificate, IsThatOfTheSegmentWithTheLargestBound) {
  const std::vector<SegmentPeaks> peaks{{{.found = 1.0, .bound = 1.1, .time = 0.5}, {.bound = 7.0}},
                                        {{.found = 0.9, .bound = 1.2, .time = 1.5}, {.bound = 6.0}}};
  const auto certificates = certificates_of({.rate = 2.0, .torque = 8.0}, peaks);
  ASSERT_EQ(certificates.size(), 2u);
  EXPECT_EQ(certificates[0].segment, 1u);
  EXPECT_EQ(certificates[0].time, 1.5);
  EXPECT_EQ(certificates[0].limit, 2.0);
  EXPECT_EQ(certificates[0].bound, 1.2);
  EXPECT_EQ(certificates[0].found, 0.9);
  EXPECT_EQ(certificates[0].text_of(0.5 / degrees), "0.5 °/s");
  EXPECT_EQ(certificates[0].id_of("bound"), "rate_bound_deg_s");
  EXPECT_EQ(certificates[1].segment, 0u);
  EXPECT_EQ(certificates[1].bound, 7.0);
  EXPECT_EQ(certificates[1].text_of(7.0), "7 N m");
  EXPECT_EQ(certificates[1].id_of("max"), "torque_max_nm");
}

TEST(Certificate, OfComponentsIsOneForEachAxisInTheUnitThatWasStated) {
  Limit limit(Eigen::Vector3d(1.0, 2.0, 3.0));
  limit.stated_in = {"rad/s2", 1.0};
  const std::vector<SegmentPeaks> peaks{{{.bound = 0.5}, {.bound = 1.5}, {.bound = 2.5}, {.bound = 0.1}}};
  const auto certificates = certificates_of({.acceleration = limit, .linear_acceleration = 4.0}, peaks);
  ASSERT_EQ(certificates.size(), 4u);
  EXPECT_EQ(certificates[1].name, "acceleration about y");
  EXPECT_EQ(certificates[1].id_of("limit"), "acceleration_y_limit_deg_s2");
  EXPECT_EQ(certificates[1].text_of(certificates[1].bound), "1.5 rad/s2");
  EXPECT_EQ(certificates[3].name, "linear acceleration");
  EXPECT_EQ(certificates[3].id_of("bound"), "linear_acceleration_bound_m_s2");
}

}}  // namespace orispline
