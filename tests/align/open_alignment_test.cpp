// SPDX-License-Identifier: Apache-2.0
#include <orispline/align.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "two_recordings.hpp"

namespace orispline { namespace {

using testing_support::Taken;
using testing_support::track_of;
using testing_support::TrueMotion;

const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, -2.0) / 3.0;
const Eigen::Quaterniond world = exp<double>(Eigen::Vector3d(0.2, 0.1, -0.3));

Expected<Alignment> alignment_of(const std::function<double(double)>& angle, double noise, double late) {
  std::mt19937_64 random(3);
  const Taken taken{.noise = noise};
  const auto turn = [&](double t) { return exp<double>(Eigen::Vector3d(angle(t) * axis)); };
  const Track fixed = track_of(taken, 0.0, turn, TrueMotion::position, random);
  const Track moved = track_of(
      taken, late, [&](double t) { return Eigen::Quaterniond(world.conjugate() * turn(t)); }, TrueMotion::position,
      random);
  return align(moved, fixed);
}

bool warns(const Alignment& alignment) {
  for (const Warning& warning : alignment.warnings)
    if (warning.code == "open_alignment") return true;
  return false;
}

/// What is open does not depend on the unit of time.
TEST(OpenAlignment, IsNoneOfAMotionThatIsSlowOrFast) {
  for (const double second : {1e-4, 1e4}) {
    std::mt19937_64 random(3);
    const Taken taken{.rate = 50.0 / second, .to = 20.0 * second, .noise = 0.01 * degree};
    const auto turn = [&](double t) { return TrueMotion::orientation(t / second); };
    const Track fixed = track_of(taken, 0.0, turn, TrueMotion::position, random);
    const Track moved = track_of(taken, 0.1373 * second, turn, TrueMotion::position, random);
    const auto found = align(moved, fixed);
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_TRUE(found->open.empty()) << second;
    EXPECT_NEAR(found->offset.to_double() / second, 0.1373, 1e-4);
  }
}

/// A turn of the world about the only axis is the same as one of the body.
TEST(OpenAlignment, IsThatOfTurnsAboutOneAxis) {
  for (const double noise : {0.0, 0.3 * degree}) {
    const auto found = alignment_of([](double t) { return 1.5 * std::sin(t) + 0.3 * t; }, noise, 0.2);
    ASSERT_TRUE(found) << describe(found.error());
    ASSERT_EQ(found->open.size(), 1u);
    EXPECT_LE(found->open[0].body.cross(axis).norm(), 0.02);
    EXPECT_LE(found->open[0].world.cross(axis).norm(), 0.02);
    EXPECT_NEAR(found->open[0].body.norm(), std::sqrt(0.5), 0.02);
    EXPECT_NEAR(found->offset.to_double(), 0.2, 5e-3);
    EXPECT_LE(angular_distance(found->world, world), 0.02);  // the body's axes stay
    EXPECT_TRUE(warns(*found));
  }
}

/// An even turn about one axis leaves the offset open too.
TEST(OpenAlignment, IsThatOfAnEvenTurn) {
  const auto found = alignment_of([](double t) { return 0.5 * t; }, 0.1 * degree, 0.0);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_EQ(found->open.size(), 2u);
  EXPECT_TRUE(warns(*found));
  const auto names_offset = [](const Warning& warning) {
    return warning.message.find("the offset of the clocks") != std::string::npos;
  };
  EXPECT_TRUE(std::ranges::any_of(found->warnings, names_offset));
}

/// Where nothing moves, one rotation is all that is known.
TEST(OpenAlignment, IsThatOfABodyAtRest) {
  const auto found = alignment_of([](double) { return 0.7; }, 0.1 * degree, 0.0);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_EQ(found->open.size(), 4u);
  EXPECT_LE(found->distance.rms, 0.3 * degree);
}

}}  // namespace orispline
