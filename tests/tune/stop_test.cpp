// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/tune/tune.hpp>
#include <support/follower.hpp>

namespace orispline { namespace {

TEST(Tune, IsStoppedAtAnyShareThatItShows) {
  KeyframeData data;
  for (int i = 0; i < 12; ++i) {
    data.times.push_back(i);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(std::sin(2.0 * i), 0.3 * i, std::cos(1.0 * i))));
  }
  const Keyframes keys = Keyframes::make(std::move(data)).value();
  for (const std::string_view method : {"quintic", "tcb", "nu"}) {
    const auto tuned = [&](testing_support::Follower& follower) {
      return tune(keys, method, {.objective = Objective::jerk}, follower.progress());
    };
    testing_support::Follower whole;
    const auto tuning = tuned(whole);
    ASSERT_TRUE(tuning) << method << ": " << describe(tuning.error());
    EXPECT_LE(tuning->energy_after, tuning->energy_before);
    const std::size_t last = whole.shares().size();
    for (std::size_t share = 1; share < last; share *= 2) {
      testing_support::Follower stopping(share);
      const auto stopped = tuned(stopping);
      ASSERT_FALSE(stopped) << method << ", stopped at share " << share << " of " << last;
      EXPECT_EQ(stopped.error().code, ErrorCode::cancelled) << method << ": " << describe(stopped.error());
    }
  }
}

}}  // namespace orispline
