// SPDX-License-Identifier: Apache-2.0
// Keys of which some leave their rates free: what keyframes accept, and what the methods that take rates make of it.
#include <gtest/gtest.h>

#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/distance.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/smooth/smooth.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

KeyframeData walk_with_free_rates() {
  KeyframeData data = random_walk(11, 6, Spacing::uneven, 0.7);
  Dice dice(12);
  data.angular_velocities = {dice.vector(), free_rate(), dice.vector(), free_rate(), free_rate(), dice.vector()};
  return data;
}

TEST(FreeRates, MustLackAllComponentsAndBeFiniteOtherwise) {
  KeyframeData data = walk_with_free_rates();
  EXPECT_TRUE(Keyframes::make(data));
  data.angular_velocities[3] = {1.0, free_rate().x(), 2.0};
  const auto mixed = Keyframes::make(data);
  ASSERT_FALSE(mixed);
  EXPECT_EQ(mixed.error().message,
            "the angular velocity lacks 1 of its 3 components, wanted all of them, or none to leave it free");
  EXPECT_EQ(mixed.error().where.key, 3u);
  data.angular_velocities[3] = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(Keyframes::make(data));
  data.angular_velocities.clear();
  data.positions.assign(6, free_rate());
  EXPECT_FALSE(Keyframes::make(data));
}

TEST(FreeRates, AreEstimatedAsWhereThereAreNone) {
  const KeyframeData data = walk_with_free_rates();
  KeyframeData without = data;
  without.angular_velocities.clear();
  for (const char* method : {"hermite-c1", "hermite-c2", "hermite-c3", "hermite-cumulative"}) {
    const AnyCurve curve = make_curve(method, keyframes(data)).value(),
                   estimated = make_curve(method, keyframes(without)).value();
    for (std::size_t i = 0; i < data.times.size(); ++i) {
      const auto& given = data.angular_velocities[i];
      const Eigen::Vector3d wanted = is_free(given) ? estimated.motion(data.times[i]).angular_velocity : given;
      EXPECT_TRUE(near(curve.motion(data.times[i]).angular_velocity, wanted, tolerance::rates)) << method << " " << i;
    }
  }
}

TEST(FreeRates, OfAllKeysAreTheSameAsNone) {
  KeyframeData data = walk_with_free_rates(), without = data;
  data.angular_velocities.assign(6, free_rate());
  without.angular_velocities.clear();
  for (const char* method : {"hermite-c1", "hermite-c2", "hermite-c3", "hermite-cumulative", "least"}) {
    const AnyCurve curve = make_curve(method, keyframes(data)).value(),
                   plain = make_curve(method, keyframes(without)).value();
    for (const double t : sample_times(data.times, 5)) EXPECT_EQ(curve(t), plain(t)) << method;
  }
}

TEST(FreeRates, AreChosenForTheLeastEnergy) {
  const KeyframeData data = walk_with_free_rates();
  const AnyCurve curve = make_curve("least", keyframes(data)).value();
  const double least = energies(curve).acceleration;
  KeyframeData moved = data;
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    const Eigen::Vector3d rate = curve.motion(data.times[i]).angular_velocity;
    const Eigen::Vector3d& given = data.angular_velocities[i];
    EXPECT_TRUE(is_free(given) || near(rate, given, tolerance::rates)) << i;
    moved.angular_velocities[i] = rate;
  }
  EXPECT_NEAR(energies(make_curve("least", keyframes(moved)).value()).acceleration / least, 1.0, 1e-7);
  moved.angular_velocities[3] += Eigen::Vector3d(0.1, 0.0, 0.0);
  EXPECT_GT(energies(make_curve("least", keyframes(moved)).value()).acceleration, least);
}

TEST(FreeRates, AreLeftOutOfWhatIsCompared) {
  KeyframeData data = walk_with_free_rates();
  const AnyCurve curve = make_curve("least", keyframes(data)).value();
  const DistanceStatistics exact = rate_error(curve, {data.times, data.angular_velocities});
  EXPECT_EQ(exact.count, 3u);
  EXPECT_LE(exact.largest, tolerance::rates);
  data.angular_velocities[2].x() += 1.0;
  const DistanceStatistics off = rate_error(curve, {data.times, data.angular_velocities});
  EXPECT_EQ(off.largest_at, 2u);
  EXPECT_NEAR(off.largest, 1.0, tolerance::rates);
}

TEST(FreeRates, DoNotHideThatTheOthersContradictTheKeys) {
  KeyframeData data = random_walk(13, 20, Spacing::even, 0.3);
  const AnyCurve curve = make_curve("auto", keyframes(data)).value();
  for (const double t : data.times) data.angular_velocities.push_back(curve.motion(t).angular_velocity);
  data.angular_velocities[4] = data.angular_velocities[9] = free_rate();
  EXPECT_TRUE(warnings_of({"hermite-c1"}, keyframes(data)).empty());
  for (auto& rate : data.angular_velocities) rate *= -1.0;
  const auto warnings = warnings_of({"hermite-c1"}, keyframes(data));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "contradicting_rates");
}

TEST(FreeRates, AreNoneOfAGyro) {
  const KeyframeData data = walk_with_free_rates();
  const auto gyro = gyro_rates_in(keyframes(data));
  ASSERT_TRUE(gyro) << describe(gyro.error());
  EXPECT_EQ(gyro->times, (std::vector{data.times[0], data.times[2], data.times[5]}));
  EXPECT_EQ(gyro->rates[1], data.angular_velocities[2]);
  KeyframeData all_free = data;
  all_free.angular_velocities.assign(data.times.size(), free_rate());
  EXPECT_FALSE(gyro_rates_in(keyframes(all_free)));
}

}}  // namespace orispline
