// SPDX-License-Identifier: Apache-2.0
#include <orispline/align.hpp>

#include <gtest/gtest.h>

#include "two_recordings.hpp"

namespace orispline { namespace {

using testing_support::Difference;
using testing_support::fixed_recording;
using testing_support::moved_recording;
using testing_support::Taken;
using testing_support::TrueMotion;

class Align : public testing::Test {
 protected:
  std::mt19937_64 random{5};
};

void expect_near(const Alignment& found, const Difference& truth, double angle, double time) {
  EXPECT_LE(angular_distance(found.world, truth.world), angle);
  EXPECT_LE(angular_distance(found.body, truth.body), angle);
  EXPECT_NEAR(found.offset.to_double(), truth.offset, time);
}

TEST_F(Align, FindsBothRotationsAndTheOffset) {
  const Difference truth;
  const auto found = align(moved_recording({}, truth, random), fixed_recording({}, random));
  ASSERT_TRUE(found) << describe(found.error());
  expect_near(*found, truth, 1e-5, 1e-5);
  EXPECT_TRUE(found->open.empty());
  EXPECT_TRUE(found->warnings.empty());
  EXPECT_FALSE(found->scale || found->translation || found->position_distance);
  EXPECT_LE(found->distance.largest, 1e-3);
}

TEST_F(Align, FindsScaleAndTranslationToo) {
  const Difference truth;
  const Taken with_positions{.has_positions = true};
  const auto found = align(moved_recording(with_positions, truth, random), fixed_recording(with_positions, random));
  ASSERT_TRUE(found) << describe(found.error());
  expect_near(*found, truth, 1e-5, 1e-5);
  EXPECT_NEAR(found->scale.value(), truth.scale, 1e-4);
  EXPECT_LE((found->translation.value() - truth.translation).norm(), 1e-3);
}

/// A fifth of the time in common only, at two rates, one of them uneven to the other.
TEST_F(Align, FindsRecordingsThatOverlapInPart) {
  const Difference truth{.offset = -7.3};
  const auto found = align(moved_recording({.rate = 37.0, .from = 6.0, .to = 26.0}, truth, random),
                           fixed_recording({.rate = 50.0, .from = 0.0, .to = 20.0}, random));
  ASSERT_TRUE(found) << describe(found.error());
  expect_near(*found, truth, 1e-4, 1e-4);
}

TEST_F(Align, CountsTheOffsetFromTheEpochs) {
  const Difference truth;
  Track moved = moved_recording({}, truth, random), fixed = fixed_recording({}, random);
  moved.epoch = Decimal::parse("1700000000.25").value();
  fixed.epoch = Decimal::parse("12.5").value();
  const auto found = align(moved, fixed);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_NEAR((found->offset - (moved.epoch - fixed.epoch)).to_double(), truth.offset, 1e-5);
  const Track there = aligned(moved, fixed, *found).value();
  EXPECT_EQ(there.epoch, fixed.epoch);
  EXPECT_NEAR(there.keys.times()[0], 0.0, 1e-5);
  moved.as_read.assign(moved.keys.orientations().begin(), moved.keys.orientations().end());
  EXPECT_TRUE(aligned(moved, fixed, *found).value().as_read.empty());  // it is another motion than was read
}

TEST_F(Align, CountsTheOffsetFromTimesThatBeginAnywhere) {
  const Difference truth;
  const double begin = 30.0;
  Difference later = truth;
  later.offset += begin;
  const auto found = align(moved_recording({}, later, random),
                           testing_support::track_of({}, begin, TrueMotion::orientation, TrueMotion::position, random));
  ASSERT_TRUE(found) << describe(found.error());
  expect_near(*found, truth, 1e-5, 1e-5);
}

TEST_F(Align, BringsOneRecordingOntoTheOther) {
  const Difference truth;
  const Taken with_positions{.has_positions = true};
  Track moved = moved_recording(with_positions, truth, random);
  const Eigen::Vector3d rate(0.3, -0.2, 0.5);
  moved.keys = moved.keys.with_rates(std::vector<Eigen::Vector3d>(moved.keys.size(), rate)).value();
  const Track fixed = fixed_recording(with_positions, random);
  const auto found = align(moved, fixed);
  ASSERT_TRUE(found) << describe(found.error());
  const Track there = aligned(moved, fixed, *found).value();
  for (std::size_t i = 0; i < there.keys.size(); i += 100) {
    const double t = there.time_of(i).to_double();
    EXPECT_LE(angular_distance(there.keys.orientations()[i], TrueMotion::orientation(t)), 1e-4);
    EXPECT_LE((there.keys.positions()[i] - TrueMotion::position(t)).norm(), 1e-3);
    EXPECT_LE((there.keys.angular_velocities()[i] - to_world<double>(truth.body, rate)).norm(), 1e-4);
  }
}

/// What is not looked for stays as it is, where it is right and where it is wrong.
TEST_F(Align, LooksOnlyForWhatItIsAskedFor) {
  const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
  const Difference world_only{.body = none, .offset = 0.0};
  const auto world =
      align(moved_recording({}, world_only, random), fixed_recording({}, random), {.body_turn = false, .offset = 0.0});
  ASSERT_TRUE(world) << describe(world.error());
  expect_near(*world, world_only, 1e-5, 0.0);
  EXPECT_EQ(world->sigmas.offset, 0.0);
  EXPECT_EQ(world->sigmas.body, Eigen::Vector3d::Zero());
  const Difference body_only{.world = none};
  const auto body = align(moved_recording({}, body_only, random), fixed_recording({}, random),
                          {.world_turn = false, .offset = body_only.offset});
  ASSERT_TRUE(body) << describe(body.error());
  expect_near(*body, body_only, 1e-5, 0.0);
  const Difference small{.body = Eigen::Quaterniond(exp<double>(Eigen::Vector3d(0.1, 0.0, 0.0)))};
  const auto wrong = align(moved_recording({}, small, random), fixed_recording({}, random), {.body_turn = false});
  ASSERT_TRUE(wrong) << describe(wrong.error());
  ASSERT_EQ(wrong->warnings.size(), 1u);
  EXPECT_EQ(wrong->warnings[0].code, "poor_alignment");
}

TEST_F(Align, KeepsTheOriginThatItIsNotAskedFor) {
  const Difference truth{.translation = Eigen::Vector3d::Zero()};
  const Taken with_positions{.to = 10.0, .has_positions = true};
  const auto found = align(moved_recording(with_positions, truth, random), fixed_recording(with_positions, random),
                           {.translation = false});
  ASSERT_TRUE(found) << describe(found.error());
  expect_near(*found, truth, 1e-5, 1e-5);
  EXPECT_NEAR(found->scale.value(), truth.scale, 1e-4);
  EXPECT_EQ(found->translation.value(), Eigen::Vector3d::Zero());
  EXPECT_EQ(found->sigmas.translation, Eigen::Vector3d::Zero());
}

TEST_F(Align, IsTurnedRoundWithTheRecordings) {
  const Difference truth;
  const Taken taken{.noise = 0.3 * degree};
  const Track moved = moved_recording(taken, truth, random), fixed = fixed_recording(taken, random);
  const auto there = align(moved, fixed), back = align(fixed, moved);
  ASSERT_TRUE(there && back);
  EXPECT_LE(angular_distance(there->world, back->world.conjugate()), 0.2 * degree);
  EXPECT_NEAR((there->offset + back->offset).to_double(), 0.0, 1e-3);
}

/// The recordings overlap by seconds, but most of them lie in a hole of the fixed one.
TEST_F(Align, RefusesAnOffsetThatBringsOnlyAFewSamplesTogether) {
  const Difference truth{.offset = 0.0};
  const Track moved = moved_recording({.from = 9.9}, truth, random), whole = fixed_recording({}, random);
  KeyframeData data = whole.keys.data(), with_hole;
  for (std::size_t i = 0; i < data.times.size(); ++i)
    if (data.times[i] < 10.0 || data.times[i] > 19.99) {
      with_hole.times.push_back(data.times[i]);
      with_hole.orientations.push_back(data.orientations[i]);
    }
  const auto found = align(moved, Track(Keyframes::make(std::move(with_hole)).value()), {.offset = 0.0});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().option, "offset");
  EXPECT_NE(found.error().message.find("side by side"), std::string::npos) << found.error().message;
}

TEST_F(Align, RefusesWhatCannotBeAligned) {
  const Difference truth;
  const Track moved = moved_recording({}, truth, random), fixed = fixed_recording({}, random);
  const auto nan = align(moved, fixed, {.offset = std::nan("")});
  ASSERT_FALSE(nan);
  EXPECT_EQ(nan.error().option, "offset");
  const auto apart = align(moved, fixed, {.offset = 100.0});
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().option, "offset");
  EXPECT_EQ(apart.error().code, ErrorCode::bad_argument);
  EXPECT_NE(apart.error().message.find("side by side"), std::string::npos) << apart.error().message;
  const std::vector<std::size_t> few{0, 1, 2, 3, 4, 5, 6};
  const auto of_few = align(moved.at(few), fixed);
  ASSERT_FALSE(of_few);
  EXPECT_EQ(of_few.error().code, ErrorCode::bad_data);
  const auto other = testing_support::track_of(
      {}, 0.0,
      [](double t) { return exp<double>(Eigen::Vector3d(3.0 * std::sin(0.37 * t), 2.0 * t, std::cos(5.0 * t))); },
      TrueMotion::position, random);
  const auto strangers = align(other, fixed);
  ASSERT_FALSE(strangers);
  EXPECT_NE(strangers.error().message.find("wanted two recordings of one motion"), std::string::npos)
      << strangers.error().message;
}

}}  // namespace orispline
