// SPDX-License-Identifier: Apache-2.0
// The cumulative cubic Bézier curve: joints, handles, the count of control points.
#include <gtest/gtest.h>

#include <families/key_steps.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(Bezier, PassesThroughEveryThirdKeyAtItsTime) {
  const Keyframes keys = keyframes(random_walk(341, 10, Spacing::uneven));
  const AnyCurve c = make_curve("bezier", keys).value();
  for (const std::size_t i : {0u, 3u, 6u, 9u})
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(c.motion(keys.times()[i], side).orientation, keys.orientations()[i], tolerance::algebra)) << i;
}

TEST(Bezier, LeavesAJointAlongItsHandleAndArrivesAlongTheOther) {
  // ω(0) = 3 φ_1/h, ω(1) = 3 φ_3/h, α(0) = 6 (φ_2 - φ_1)/h² + the turn of the frame, zero at u = 0.
  const Keyframes keys = keyframes(random_walk(342, 7, Spacing::uneven));
  const AnyCurve c = make_curve("bezier", keys).value();
  for (const std::size_t first : {0u, 3u}) {
    const double start = keys.times()[first], end = keys.times()[first + 3], h = end - start;
    EXPECT_TRUE(near(c.motion(start).angular_velocity, 3.0 * step(keys, first) / h, tolerance::series));
    EXPECT_TRUE(near(c.motion(end, Side::left).angular_velocity, 3.0 * step(keys, first + 2) / h, tolerance::series));
    EXPECT_TRUE(near(c.motion(start).angular_acceleration, 6.0 * (step(keys, first + 1) - step(keys, first)) / (h * h),
                     tolerance::series));
  }
}

TEST(Bezier, IgnoresTheTimesOfInnerControlPoints) {
  KeyframeData data = random_walk(343, 7, Spacing::even);
  const AnyCurve before = make_curve("bezier", keyframes(data)).value();
  for (const std::size_t inner : {1u, 2u, 4u, 5u}) data.times[inner] += 0.2;
  const AnyCurve after = make_curve("bezier", keyframes(data)).value();
  for (const double t : sample_times(before.knots().times())) EXPECT_EQ(before(t).coeffs(), after(t).coeffs());
}

TEST(Bezier, IsC1WhereTheHandlesOfAJointMatchInTime) {
  // Steps of 3 and 1.5 s at the joint: the leaving handle must be half as long as the arriving one.
  KeyframeData data = random_walk(344, 7, Spacing::even);
  data.times = {0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 4.5};
  const Eigen::Vector3d arriving = increment<double>(data.orientations[2], data.orientations[3]);
  data.orientations[4] = data.orientations[3] * exp<double>(0.5 * arriving);
  const AnyCurve c = make_curve("bezier", keyframes(data)).value();
  const Motion left = c.motion(3.0, Side::left), right = c.motion(3.0, Side::right);
  EXPECT_TRUE(near(left.angular_velocity, right.angular_velocity, tolerance::series));
  EXPECT_GT((left.angular_acceleration - right.angular_acceleration).norm(), tolerance::visible_jump);
}

TEST(Bezier, RefusesAnyOtherCountThan3kPlus1) {
  for (const std::size_t count : {5u, 6u, 8u, 9u, 20u}) {
    const auto c = make_curve("bezier", keyframes(random_walk(345, count, Spacing::even)));
    ASSERT_FALSE(c) << count;
    EXPECT_EQ(c.error().code, ErrorCode::bad_data);
    EXPECT_EQ(c.error().message, "bezier needs 3k+1 keys (4, 7, 10, ...), found " + std::to_string(count));
  }
}

TEST(Bezier, InSpaceIsTheBezierCurve) {
  KeyframeData data = random_walk(346, 4, Spacing::even);
  data.times = {0.0, 1.0, 2.0, 4.0};
  data.positions = {{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, -1}};
  const PoseCurve pose = make_pose_curve("bezier", keyframes(data)).value();
  for (const double u : {0.0, 0.25, 0.6, 1.0}) {
    const double v = 1.0 - u;
    const Eigen::Vector3d wanted = v * v * v * data.positions[0] + 3 * v * v * u * data.positions[1] +
                                   3 * v * u * u * data.positions[2] + u * u * u * data.positions[3];
    EXPECT_TRUE(near(pose.position->linear_motion(4.0 * u).position, wanted, tolerance::algebra)) << u;
  }
}

}}  // namespace orispline
