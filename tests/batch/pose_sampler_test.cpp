// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/pose_sampler.hpp>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

const KeyframeData sampled_walk = posed_walk(7, 20, testing_support::Spacing::uneven, 0.6);

PoseSampler sampler_of(std::string_view method) {
  return PoseSampler(make_pose_curve(method, keyframes(sampled_walk)).value());
}

struct Room {
  std::vector<double> q, w, a, j;

  explicit Room(std::size_t count) : q(4 * count), w(3 * count), a(3 * count), j(3 * count) {}
  [[nodiscard]] Samples<double> samples() {
    return {.orientations = q, .angular_velocities = w, .angular_accelerations = a, .angular_jerks = j};
  }
};

TEST(PoseSampler, TurnsRatesToTheWorld) {
  const PoseSampler sampler = sampler_of("timed-c3");
  const auto times = sample_times(sampled_walk.times, 3);
  Room room(times.size());
  ASSERT_TRUE(sampler.sample_at<double>(times, room.samples(), Extrapolation::hold, RateFrame::world));
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Motion motion = sampler.curve().orientation.motion(times[k]);
    const auto at = [k](const std::vector<double>& rows) {
      return Eigen::Map<const Eigen::Vector3d>(rows.data() + 3 * k);
    };
    EXPECT_LT((at(room.w) - angular_velocity_world(motion)).norm(), 1e-11);
    EXPECT_LT((at(room.a) - angular_acceleration_world(motion)).norm(), 1e-9);
    EXPECT_LT((at(room.j) - angular_jerk_world(motion)).norm(), 1e-6);
  }
}

TEST(PoseSampler, HasTheBitsOfATimeWhateverTheOthersAre) {
  const PoseSampler sampler = sampler_of("auto");
  auto times = sample_times(sampled_walk.times, 30);
  Room together(times.size());
  ASSERT_TRUE(sampler.sample_at<double>(times, together.samples()));
  for (const std::size_t k : {std::size_t{3}, std::size_t{250}, times.size() - 1}) {
    Room alone(1);
    ASSERT_TRUE(sampler.sample_at<double>({&times[k], 1}, alone.samples()));
    EXPECT_TRUE(std::equal(alone.q.begin(), alone.q.end(), together.q.begin() + static_cast<std::ptrdiff_t>(4 * k)));
    EXPECT_TRUE(std::equal(alone.j.begin(), alone.j.end(), together.j.begin() + static_cast<std::ptrdiff_t>(3 * k)));
  }
}

TEST(PoseSampler, MakesAsManyAtATimeAsThreadsShare) {
  EXPECT_LT(samples_at_a_time({.threads = 1}), samples_at_a_time({.threads = 2}));
  EXPECT_LT(samples_at_a_time({.threads = 2}), samples_at_a_time({.threads = 0}));
}

}}  // namespace orispline
