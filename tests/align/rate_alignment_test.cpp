// SPDX-License-Identifier: Apache-2.0
#include <orispline/align.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/smooth/smoothing_element.hpp>

#include "rate_recordings.hpp"

namespace orispline { namespace {

using rate_recordings::askew;
using rate_recordings::gyro_of;
using rate_recordings::poses_of;
using rate_recordings::Sensor;
using rate_recordings::SimulatedBody;

constexpr std::uint64_t clean_seeds = 6, wild_seeds = 3;

/// Root mean square errors over some seeds, per axis, and largest ones in units of what was stated.
struct Errors {
  double offset = 0.0, body = 0.0, bias = 0.0;                       // [s], [rad], [rad/s]
  double stated_offset = 0.0, stated_body = 0.0, stated_bias = 0.0;  // root mean squares in standard deviations
  double largest_body = 0.0;                                         // [rad], about any axis
  std::size_t count = 0;

  void add(const RateAlignment& found, const Sensor& truth, const Eigen::Vector3d& bias_between) {
    const double late = found.offset.to_double() - truth.late;
    const Eigen::Vector3d turn = shortest_increment(truth.body.conjugate(), found.body.conjugate());
    const Eigen::Vector3d more = found.bias - bias_between;
    offset += late * late;
    body += turn.squaredNorm() / 3.0;
    bias += more.squaredNorm() / 3.0;
    stated_offset += late * late / (found.offset_sigma * found.offset_sigma);
    stated_body += turn.cwiseQuotient(found.body_sigma).squaredNorm() / 3.0;
    stated_bias += more.cwiseQuotient(found.bias_sigma).squaredNorm() / 3.0;
    largest_body = std::max(largest_body, turn.norm());
    ++count;
  }
  [[nodiscard]] double rms(double Errors::*which) const { return std::sqrt(this->*which / static_cast<double>(count)); }
};

Sensor second_gyro(double wild) { return {.bias = degree * Eigen::Vector3d(0.5, -0.3, 1.0), .wild = wild}; }

Errors errors_of_two_gyros(double wild) {
  Errors errors;
  for (std::uint64_t seed = 0; seed < (wild > 0.0 ? wild_seeds : clean_seeds); ++seed) {
    const SimulatedBody motion(seed);
    Sensor sensor = askew(seed);
    sensor.wild = wild;
    const Sensor other = second_gyro(wild);
    const auto found = align(gyro_of(motion, sensor, 100 + seed), gyro_of(motion, other, 200 + seed));
    EXPECT_TRUE(found) << describe(found.error());
    if (found) errors.add(*found, sensor, sensor.bias - to_body<double>(sensor.body, other.bias));
  }
  return errors;
}

Errors errors_beside_poses(double wild) {
  Errors errors;
  for (std::uint64_t seed = 0; seed < (wild > 0.0 ? wild_seeds : clean_seeds); ++seed) {
    const SimulatedBody motion(seed);
    Sensor sensor = askew(seed);
    sensor.wild = wild;
    const auto found =
        align(gyro_of(motion, sensor, 300 + seed), poses_of(motion, {.noise = 0.5 * degree, .wild = wild}, 400 + seed));
    EXPECT_TRUE(found) << describe(found.error());
    if (found) errors.add(*found, sensor, sensor.bias);
  }
  return errors;
}

const Errors& two_clean_gyros() {
  static const Errors errors = errors_of_two_gyros(0.0);
  return errors;
}
const Errors& clean_gyro_beside_poses() {
  static const Errors errors = errors_beside_poses(0.0);
  return errors;
}

/// The mean of 6000 rates of 0.57 °/s of noise is known to 0.0074 °/s, that of the difference of two gyros to 0.0104.
TEST(RateAlignment, FindsTwoGyrosAsNearAsTheirNoiseAllows) {
  const Errors& errors = two_clean_gyros();
  EXPECT_LE(errors.rms(&Errors::offset), 1e-4);
  EXPECT_LE(errors.largest_body, 0.05 * degree);
  EXPECT_LE(errors.rms(&Errors::bias), 0.0125 * degree);
}

TEST(RateAlignment, FindsAGyroBesidePosesAsNearAsItsNoiseAllows) {
  const Errors& errors = clean_gyro_beside_poses();
  EXPECT_LE(errors.rms(&Errors::offset), 1e-4);
  EXPECT_LE(errors.largest_body, 0.05 * degree);
  EXPECT_LE(errors.rms(&Errors::bias), 0.01 * degree);
}

TEST(RateAlignment, IsAsSureAsItStates) {
  for (const Errors& errors : {two_clean_gyros(), clean_gyro_beside_poses()})
    for (const auto which : {&Errors::stated_offset, &Errors::stated_body, &Errors::stated_bias}) {
      EXPECT_LE(errors.rms(which), 1.6);
      EXPECT_GE(errors.rms(which), 0.5);
    }
}

TEST(RateAlignment, IsNotHarmedByATenthOfWildSamplesInBothRecordings) {
  for (const Errors& errors : {errors_of_two_gyros(0.1), errors_beside_poses(0.1)}) {
    EXPECT_LE(errors.rms(&Errors::offset), 5e-4);
    EXPECT_LE(errors.rms(&Errors::body), 0.05 * degree);
    EXPECT_LE(errors.rms(&Errors::bias), 0.04 * degree);
  }
}

/// A gyro that reads zero, or one value, in one run of a tenth of all rows, as when it hung.
TEST(RateAlignment, LeavesOutARunInWhichTheGyroHung) {
  const SimulatedBody motion(3);
  const Sensor sensor = askew(3);
  for (const bool reads_zero : {true, false}) {
    GyroTrack hung = gyro_of(motion, sensor, 21);
    const Eigen::Vector3d value = reads_zero ? Eigen::Vector3d::Zero() : hung.rates.rates[2000];
    for (std::size_t k = 2000; k < 2600; ++k) hung.rates.rates[k] = value;
    const auto beside_gyro = align(hung, gyro_of(motion, {}, 22));
    const auto beside_poses = align(hung, poses_of(motion, {.noise = 0.5 * degree}, 23));
    for (const auto* found : {&beside_gyro, &beside_poses}) {
      ASSERT_TRUE(*found) << describe(found->error());
      EXPECT_LE(angular_distance((*found)->body, sensor.body), 0.06 * degree);
      EXPECT_NEAR((*found)->offset.to_double(), sensor.late, 3e-4);
      EXPECT_LE(((*found)->bias - sensor.bias).norm(), 0.04 * degree);
    }
    EXPECT_GE(beside_gyro->rejected_fixed.size(), 500U);
    EXPECT_GE(beside_poses->rejected_moved.size(), 500U);
  }
}

/// Poses moved onto a gyro say the same as the gyro moved onto them.
TEST(RateAlignment, IsTheSameTheOtherWayRound) {
  const SimulatedBody motion(4);
  const Sensor sensor = askew(4);
  const GyroTrack gyro = gyro_of(motion, sensor, 1);
  const Track poses = poses_of(motion, {.rate = 20.0, .noise = 0.5 * degree}, 2);
  const auto one = align(gyro, poses), other = align(poses, gyro);
  ASSERT_TRUE(one) << describe(one.error());
  ASSERT_TRUE(other) << describe(other.error());
  EXPECT_LE(angular_distance(one->body, other->body.conjugate()), 1e-15);
  EXPECT_EQ(one->offset, -other->offset);
  EXPECT_EQ(one->bias, other->bias);
  EXPECT_NEAR(one->body_sigma.norm(), other->body_sigma.norm(), 1e-12);
  EXPECT_LE(angular_distance(one->body, sensor.body), 0.15 * degree);
  EXPECT_NEAR(one->offset.to_double(), sensor.late, 1e-3);
}

/// Aligned rates have no bias and the axes of the body; aligned orientations have the rates of the gyro.
TEST(RateAlignment, BringsRatesAndOrientationsThere) {
  const SimulatedBody motion(5);
  const Sensor sensor = askew(5);
  GyroTrack gyro = gyro_of(motion, sensor, 1);
  gyro.epoch = Decimal::parse("1700000000.125").value();
  const Track poses = poses_of(motion, {.noise = 0.1 * degree}, 2);
  const auto found = align(gyro, poses);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_NEAR((found->offset - gyro.epoch).to_double(), sensor.late, 3e-4);
  const GyroTrack there = aligned(gyro, poses.epoch, *found);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < there.rates.times.size(); ++k) {
    const Eigen::Vector3d left = there.rates.rates[k] - motion.rate(there.rates.times[k]);
    EXPECT_LE(left.norm(), 4.0 * degree);
    sum += left / static_cast<double>(there.rates.times.size());
  }
  EXPECT_LE(sum.norm(), 0.03 * degree);
  const auto back = align(poses, gyro);
  ASSERT_TRUE(back) << describe(back.error());
  const auto moved = aligned(poses, gyro, *back);
  ASSERT_TRUE(moved) << describe(moved.error());
  EXPECT_EQ(moved->epoch, gyro.epoch);
  EXPECT_NEAR(moved->keys.times()[7], poses.keys.times()[7] + sensor.late, 3e-4);
  EXPECT_LE(angular_distance(moved->keys.orientations()[7], poses.keys.orientations()[7] * sensor.body), 0.1 * degree);
}

/// About one axis nobody can say how the gyro is turned about it; the two other turns, the clock and the bias are
/// known.
TEST(RateAlignment, SaysThatOneAxisLeavesATurnAboutItOpen) {
  SimulatedBody motion(6);
  motion.only_axis = Eigen::Vector3d(0.0, 0.6, 0.8);
  const Sensor tilted{.body = exp<double>(Eigen::Vector3d(0.3, 0.0, 0.0)), .late = 0.1, .bias = {0.02, -0.03, 0.01}};
  const GyroTrack gyro = gyro_of(motion, tilted, 1);
  for (const bool has_poses : {false, true}) {
    const auto found =
        has_poses ? align(gyro, poses_of(motion, {.noise = 0.5 * degree}, 2)) : align(gyro, gyro_of(motion, {}, 3));
    ASSERT_TRUE(found) << describe(found.error());
    ASSERT_EQ(found->open.size(), 1U);
    EXPECT_GE(std::abs(found->open[0].body.normalized().dot(*motion.only_axis)), 0.999);
    ASSERT_EQ(found->warnings.size(), 1U);
    EXPECT_EQ(found->warnings[0].code, "open_alignment");
    const Eigen::Vector3d of_gyro = to_body<double>(tilted.body, *motion.only_axis);
    EXPECT_LE((to_world<double>(found->body, of_gyro) - *motion.only_axis).norm(), 0.1 * degree);
    EXPECT_NEAR(found->offset.to_double(), 0.1, 5e-4);
    EXPECT_NEAR(found->bias.dot(of_gyro), tilted.bias.dot(of_gyro), 0.05 * degree);
  }
}

TEST(RateAlignment, RefusesABodyAtRest) {
  SimulatedBody motion(7);
  motion.rests = true;
  for (const bool has_poses : {false, true}) {
    const auto found = has_poses ? align(gyro_of(motion, askew(7), 1), poses_of(motion, {.noise = 0.5 * degree}, 2))
                                 : align(gyro_of(motion, askew(7), 1), gyro_of(motion, {}, 2));
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::bad_data);
    EXPECT_NE(found.error().message.find("found no change of the rates that stands out of the noise"),
              std::string::npos)
        << found.error().message;
  }
}

TEST(RateAlignment, RefusesTwoMotions) {
  const SimulatedBody one(8), other(9);
  const auto gyros = align(gyro_of(one, {}, 1), gyro_of(other, {}, 2));
  const auto poses = align(gyro_of(one, {}, 1), poses_of(other, {.noise = 0.5 * degree}, 2));
  for (const auto* found : {&gyros, &poses}) {
    ASSERT_FALSE(*found);
    EXPECT_NE(found->error().message.find("wanted two recordings of one motion"), std::string::npos);
  }
}

TEST(RateAlignment, KeepsWhatIsStated) {
  const SimulatedBody motion(10);
  const Sensor sensor{.late = 0.2, .bias = {0.01, 0.02, 0.03}};
  const GyroTrack gyro = gyro_of(motion, sensor, 1), other = gyro_of(motion, {}, 2);
  const auto found = align(gyro, other, {.body_turn = false, .offset = 0.2});
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_TRUE(found->body.isApprox(Eigen::Quaterniond::Identity(), 0.0));
  EXPECT_EQ(found->offset, Decimal::from_double(0.2));
  EXPECT_EQ(found->offset_sigma, 0.0);
  EXPECT_EQ(found->body_sigma.norm(), 0.0);
  EXPECT_LE((found->bias - sensor.bias).norm(), 0.04 * degree);
  const auto far = align(gyro, other, {.offset = 1000.0});
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(far.error().option, "offset");
}

TEST(RateAlignment, RefusesBadRates) {
  const SimulatedBody motion(11);
  const GyroTrack good = gyro_of(motion, {}, 1);
  GyroTrack bad = good;
  bad.rates.times[7] = bad.rates.times[6];
  EXPECT_NE(align(bad, good).error().message.find("rate 7"), std::string::npos);
  bad = good;
  bad.rates.rates[9].x() = std::nan("");
  EXPECT_NE(align(bad, good).error().message.find("rate 9"), std::string::npos);
  bad.rates.times.resize(5);
  EXPECT_FALSE(align(good, bad));
  bad.rates.rates.resize(5);
  EXPECT_NE(align(good, bad).error().message.find("found 5 rates, wanted 8 at least"), std::string::npos);
}

/// Errors of scale of 5 %, as cheap gyros have, are more than a rotation and a bias explain.
TEST(RateAlignment, WarnsOfWhatIsNoAlignment) {
  const SimulatedBody motion(12);
  GyroTrack scaled = gyro_of(motion, {.noise = 0.1 * degree}, 1);
  for (Eigen::Vector3d& rate : scaled.rates.rates) rate.x() *= 1.05;
  const auto found = align(scaled, gyro_of(motion, {.noise = 0.1 * degree}, 2));
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_GT(found->excess, 3.0);
  ASSERT_EQ(found->warnings.size(), 1U);
  EXPECT_EQ(found->warnings[0].code, "poor_alignment");
}

/// One orientation in five hundred is wild.
TEST(RateAlignment, NamesTheOrientationsThatDoNotCount) {
  const SimulatedBody motion(14);
  KeyframeData data = poses_of(motion, {.noise = 0.1 * degree}, 2).keys.data();
  std::vector<std::size_t> wild;
  for (std::size_t i = 500; i < data.orientations.size(); i += 500) {
    wild.push_back(i);
    data.orientations[i] = data.orientations[i] * exp<double>(Eigen::Vector3d(0.5, 0.4, -0.3));
  }
  const auto found = align(gyro_of(motion, {}, 1), Track(Keyframes::make(std::move(data)).value()));
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_TRUE(std::ranges::includes(found->rejected_fixed, wild));
  EXPECT_LE(found->rejected_fixed.size(), 100U);
}

/// What is far beyond the noise of a good gyro is near in units of what is left of a poor one: every orientation
/// counts.
TEST(RateAlignment, ComparesEveryOrientationWithAPoorGyro) {
  const SimulatedBody motion(13);
  GyroTrack scaled = gyro_of(motion, {.noise = 0.02 * degree}, 1);
  for (Eigen::Vector3d& rate : scaled.rates.rates) rate.x() *= 1.1;
  const Track poses = poses_of(motion, {.noise = 0.02 * degree}, 2);
  const auto found = align(scaled, poses);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_GT(found->excess, 6.0);
  EXPECT_GE(found->compared, poses.keys.size() * 99 / 100);
}

}}  // namespace orispline
