// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <stop_token>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/base/progress.hpp>

namespace orispline::testing_support {

/// Notes what a task shows of itself, and asks it to stop when it has shown a number of shares.
class Follower {
 public:
  explicit Follower(std::size_t shares_until_stop = std::numeric_limits<std::size_t>::max())
      : shares_until_stop_(shares_until_stop) {}

  [[nodiscard]] Progress progress() {
    return {.stop = source_.get_token(), .show = [this](double share) {
              shares_.push_back(share);
              if (shares_.size() == shares_until_stop_) source_.request_stop();
            }};
  }
  [[nodiscard]] const std::vector<double>& shares() const { return shares_; }

 private:
  std::stop_source source_;
  std::size_t shares_until_stop_;
  std::vector<double> shares_;
};

/// `run(progress)` shows shares that rise to 1, and ends soon where it is asked to stop among them: not more than
/// `most_later` shares after that.
template <class Run>
void expect_to_be_followed_and_stopped(Run run, std::size_t most_later = 0) {
  Follower whole;
  const auto done = run(whole.progress());
  ASSERT_TRUE(done) << describe(done.error());
  ASSERT_GE(whole.shares().size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(whole.shares()));
  EXPECT_GT(whole.shares().front(), 0.0);
  EXPECT_LT(whole.shares()[whole.shares().size() - 2], 1.0);
  EXPECT_EQ(whole.shares().back(), 1.0);
  for (const std::size_t stop_at : {std::size_t{1}, whole.shares().size() / 2}) {
    Follower stopping(stop_at);
    const auto stopped = run(stopping.progress());
    ASSERT_FALSE(stopped) << "stopped at share " << stop_at << " of " << whole.shares().size();
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
    EXPECT_LE(stopping.shares().size(), stop_at + most_later);
  }
}

}  // namespace orispline::testing_support
