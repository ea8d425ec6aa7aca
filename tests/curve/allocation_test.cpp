// SPDX-License-Identifier: Apache-2.0
// Evaluation allocates nothing.
#include <memory>

#include <gtest/gtest.h>

#include <curve/counting_new.hpp>
#include <orispline/families/motion_band.hpp>
#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(Allocation, IsCountedAtAll) {
  const std::size_t before = allocations_of_this_thread();
  const auto number = std::make_unique<int>(1);
  EXPECT_EQ(allocations_of_this_thread(), before + 1) << *number;
}

TEST(Allocation, DoesNotHappenWhereABandIsAskedFor) {
  const KeyframeData data = random_walk(212, 30, Spacing::uneven, 0.4);
  const MotionBand band = MotionBand::make("measured", keyframes(data), 0.9).value();
  const std::vector<double> times = sample_times(data.times);
  double sum = 0.0;
  const std::size_t before = allocations_of_this_thread();
  for (const double t : times) sum += band(t);
  EXPECT_EQ(allocations_of_this_thread(), before) << sum;
}

TEST(Allocation, DoesNotHappenDuringEvaluation) {
  KeyframeData data = random_walk(211, 10, Spacing::uneven, 0.8);
  for (std::size_t i = 0; i < 10; ++i) data.positions.emplace_back(static_cast<double>(i), 0.0, 1.0);
  const Keyframes keys = keyframes(data);
  for (const FamilyInfo& family : families_info()) {
    const PoseCurve curve = make_pose_curve(family.name, keys).value();
    const std::vector<double> times = sample_times(keys.times());
    double sum = 0.0;

    const std::size_t before = allocations_of_this_thread();
    for (const double t : times) {
      sum += curve.orientation(t).w() + curve.orientation.motion(t).angular_jerk.x();
      sum += curve.orientation.motion(t - 100.0).orientation.x();
      sum += curve.position->linear_motion(t).velocity.x();
    }
    const AnyCurve copy = curve.orientation;
    sum += copy.domain().start;
    const std::size_t after = allocations_of_this_thread();

    EXPECT_EQ(after, before) << family.name << ", checksum " << sum;
  }
}

}}  // namespace orispline
