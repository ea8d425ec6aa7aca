// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <stop_token>
#include <thread>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/tune/tune.hpp>

namespace orispline { namespace {

TEST(Tune, MayBeStoppedAtAnyMoment) {
  KeyframeData data;
  for (int i = 0; i < 40; ++i) {
    data.times.push_back(i);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(std::sin(2.0 * i), 0.3 * i, std::cos(1.0 * i))));
  }
  const Keyframes keys = Keyframes::make(std::move(data)).value();
  for (const std::string_view method : {"quintic", "tcb", "nu"}) {
    std::size_t cancelled = 0;
    for (int wait = 0; wait < 40; ++wait) {
      std::stop_source source;
      std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(50 * wait));
        source.request_stop();
      });
      const auto tuning = tune(keys, method, {.objective = Objective::jerk}, {.stop = source.get_token()});
      if (tuning) {
        EXPECT_LE(tuning->energy_after, tuning->energy_before);
        continue;
      }
      EXPECT_EQ(tuning.error().code, ErrorCode::cancelled) << method << ": " << describe(tuning.error());
      ++cancelled;
    }
    EXPECT_GT(cancelled, 0u) << method;
  }
}

}  // namespace

}  // namespace orispline
