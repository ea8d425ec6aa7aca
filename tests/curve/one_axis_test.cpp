// SPDX-License-Identifier: Apache-2.0
// Turns about one axis: what counts as one, how far round an increment goes, and the point that both charts agree on.
#include <orispline/curve/one_axis.hpp>

#include <array>

#include <gtest/gtest.h>

#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

const Eigen::Vector3d axis(0.48, -0.6, 0.64), across(0.8, 0.64, 0.0);

TEST(OneAxis, IsToldFromTurnsThatPointAsideByMoreThanAMillionth) {
  EXPECT_TRUE(have_one_axis(std::array<Eigen::Vector3d, 3>{2.0 * axis, -3e4 * axis, Eigen::Vector3d::Zero()}));
  EXPECT_TRUE(have_one_axis(std::array<Eigen::Vector3d, 2>{2.0 * axis, 1e-7 * across}));
  EXPECT_FALSE(have_one_axis(std::array<Eigen::Vector3d, 2>{2.0 * axis, 1e-5 * across}));
  EXPECT_TRUE(have_one_axis(std::array<Eigen::Vector3d, 2>{1e4 * axis, 1e4 * axis + 1e-3 * across}));
  EXPECT_FALSE(have_one_axis(std::array<Eigen::Vector3d, 2>{1e4 * axis, 1e4 * axis + across}));
  EXPECT_TRUE(have_one_axis(std::array<Eigen::Vector3d, 2>{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}));
}

TEST(OneAxis, AnIncrementGoesAsFarRoundAsItsEstimate) {
  const Eigen::Quaterniond from = exp<double>(Eigen::Vector3d(0.1, 0.2, 0.3));
  for (const double angle : {-30.0, -7.0, -1.0, 0.0, 0.5, 6.2, 6.4, 13.0, 40.0}) {
    const Eigen::Quaterniond to = from * exp<double>(angle * axis);
    EXPECT_TRUE(near(increment_near(angle * axis, from, to), angle * axis, tolerance::series)) << angle;
  }
  EXPECT_TRUE(near(increment_near(2.0 * full_turn * axis, from, from), 2.0 * full_turn * axis, tolerance::exact));
}

TEST(OneAxis, APointIsMetAtBothEndsAlsoWhereItPointsAside) {
  const Eigen::Quaterniond from = exp<double>(Eigen::Vector3d(0.1, 0.2, 0.3));
  const Eigen::Vector3d step = 0.7 * axis + 1e-7 * across;
  const Eigen::Quaterniond to = from * exp<double>(step);
  const Eigen::Vector3d way = 11.0 * axis;
  EXPECT_TRUE(near(displaced_about_one_axis<double>(from, to, step, way, 0.0), from * exp<double>(way), 1e-15));
  EXPECT_TRUE(near(displaced_about_one_axis<double>(from, to, step, way, 1.0),
                   to * exp<double>(Eigen::Vector3d(way - step)), 1e-15));
  const Eigen::Vector3d mean = mixed<double>(way, step, 0.25);
  EXPECT_TRUE(near(mean, 0.75 * way + 0.25 * step, tolerance::exact));
  EXPECT_EQ(mixed<double>(way, step, 1.0), step);
}

}}  // namespace orispline
