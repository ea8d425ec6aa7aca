// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mean/set_of.hpp"

namespace orispline { namespace {

using testing_support::base_pose;
using testing_support::degree;
using testing_support::SetOf;
using testing_support::turned;

const MeanOptions each_second{.every = 1.0};

TEST(MeanInWindows, HaveWhatIsInThemFromTheirBeginUpToTheirEnd) {
  SetOf set = turned(base_pose, {{0, 0, 0}, {0, 0, 10}, {0, 0, 40}, {0, 0, 70}});
  set.positions = {{0, 0, 0}, {2, 0, 0}, {5, 0, 0}, {9, 0, 0}};
  const auto found = mean_in_windows(std::vector{5.0, 5.5, 6.0, 9.25}, set.view(), each_second);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 3u);
  const std::vector<double> times{5.5, 6.5, 9.5}, angles{5.0, 40.0, 70.0}, places{1.0, 5.0, 9.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [time, first, one] = (*found)[i];
    EXPECT_EQ(time, times[i]);
    EXPECT_LT(angular_distance(one.orientation, turned(base_pose, {{0, 0, angles[i]}}).orientations[0]), 1e-15);
    EXPECT_EQ(one.position->x(), places[i]);
    EXPECT_EQ(first, i == 0 ? 0u : i + 1);
    EXPECT_GE(one.farthest, first);
    EXPECT_GE(*one.farthest_position, first);
  }
}

TEST(MeanInWindows, AreOneWithoutALength) {
  const SetOf set = turned(base_pose, {{0, 0, 0}, {0, 0, 10}});
  const auto found = mean_in_windows(std::vector{2.0, 7.0}, set.view());
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 1u);
  EXPECT_EQ(found->front().time, 4.5);
  EXPECT_NEAR(found->front().mean.largest_distance, 5.0 * degree, 1e-15);
}

TEST(MeanInWindows, AreLeftOutWhereNothingHasAWeight) {
  SetOf set = turned(base_pose, {{0, 0, 0}, {0, 0, 10}, {0, 0, 40}});
  set.weights = {1.0, 0.0, 2.0};
  const auto found = mean_in_windows(std::vector{0.0, 1.0, 2.0}, set.view(), each_second);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 2u);
  EXPECT_EQ((*found)[1].first, 2u);
  set.weights = {0.0, 0.0, 0.0};
  EXPECT_EQ(describe(mean_in_windows(std::vector{0.0, 1.0, 2.0}, set.view(), each_second).error()),
            "found the weight 0 at every orientation, wanted one above 0 at least");
}

TEST(MeanInWindows, SayWhatIsWrongAndWhere) {
  SetOf set = turned(base_pose, {{0, 0, 0}, {0, 0, 10}, {0, 0, 190}});
  const std::vector<double> times{0.0, 1.0, 1.5};
  EXPECT_EQ(mean_in_windows(times, set.view(), each_second).error().where.key, 1u);
  set.weights = {1.0, 1.0, -1.0};
  const auto negative = mean_in_windows(times, set.view(), each_second);
  EXPECT_EQ(describe(negative.error()), "key 2: found the weight -1, wanted 0 or a number above it");
  EXPECT_EQ(describe(mean_in_windows(std::vector{0.0}, set.view(), each_second).error()),
            "found 1 time of 3 orientations, wanted one of each");
  EXPECT_EQ(mean_in_windows(times, set.view(), {.every = -1.0}).error().option, "every");
  EXPECT_EQ(describe(mean_in_windows({}, {}, each_second).error()), "found no orientations, wanted one at least");
}

}}  // namespace orispline
