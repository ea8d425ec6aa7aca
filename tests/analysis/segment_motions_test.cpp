// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/segment_motions.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

std::vector<double> times_of(const KnotSpan& span, std::size_t count) {
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k)
    times.push_back(span.start() + span.step() * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
  return times;
}

void expect_near(const Eigen::Vector3d& found, const Eigen::Vector3d& wanted) {
  EXPECT_LE((found - wanted).norm(), 1e-11 * (1.0 + wanted.norm()));
}

TEST(SegmentMotions, AreThoseOfTheCurveHoweverManyTogetherAndWhateverIsWanted) {
  const Keyframes keys =
      testing_support::keyframes(testing_support::random_walk(5, 10, testing_support::Spacing::even, 1.0));
  for (const char* method : {"auto", "quintic", "rational", "squad", "bezier", "biarcs"}) {
    SCOPED_TRACE(method);
    const auto made = make_curve(method, keys);
    ASSERT_TRUE(made) << describe(made.error());
    const AnyCurve& curve = *made;
    for (const MotionPart wanted : {MotionPart::angular_velocities, MotionPart::rates, MotionPart::all})
      for (const std::size_t count : {std::size_t{1}, std::size_t{5}, SegmentMotions::most}) {
        SegmentMotions motions(curve, 1, wanted);
        const auto times = times_of(curve.knots().span(1), count);
        EXPECT_FALSE(motions.is_gap());
        motions.evaluate(times);
        for (std::size_t i = 0; i < count; ++i) {
          const Motion expected = curve.motion_on(1, times[i]);
          expect_near(motions.angular_velocity(i), expected.angular_velocity);
          if (wanted == MotionPart::angular_velocities) continue;
          expect_near(motions.angular_acceleration(i), expected.angular_acceleration);
          expect_near(motions.rates(i).angular_jerk, expected.angular_jerk);
          if (wanted == MotionPart::rates) continue;
          EXPECT_LE(angular_distance(motions.motion(i).orientation, expected.orientation), 1e-14);
        }
      }
  }
}

}}  // namespace orispline
