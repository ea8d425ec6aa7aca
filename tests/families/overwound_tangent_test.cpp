// SPDX-License-Identifier: Apache-2.0
// Handles that turn a full turn away from their key: told, and the curve is C1 just where none is told.
#include <algorithm>

#include <gtest/gtest.h>

#include <orispline/analysis/continuity.hpp>
#include <orispline/curve/one_axis.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Three keys about z: a turn within 1 s, then rest for 10 s.
Keyframes turn_and_rest(double turn) {
  KeyframeData data;
  data.times = {0.0, 1.0, 11.0};
  for (const double angle : {0.0, turn, turn}) data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  return keyframes(data);
}

/// The same backwards in time: rest, then a turn.
Keyframes rest_and_turn(double turn) {
  KeyframeData data;
  data.times = {0.0, 10.0, 11.0};
  for (const double angle : {0.0, 0.0, turn}) data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  return keyframes(data);
}

bool jumps(const AnyCurve& curve) { return continuity_at_keys(curve, Seam::open).order() < 1; }

void expect_the_limit(const std::string& family, Keyframes (*keys)(double), double limit) {
  SCOPED_TRACE(family);
  const Keyframes below = keys(0.999 * limit), above = keys(1.001 * limit);
  EXPECT_FALSE(jumps(make_curve(family, below).value()));
  EXPECT_FALSE(overwound_tangent(family, below).value());
  EXPECT_TRUE(jumps(make_curve(family, above).value()));
  const auto wound = overwound_tangent(family, above).value();
  ASSERT_TRUE(wound);
  EXPECT_EQ(wound->key, 1U);
  EXPECT_NEAR(wound->turn, 1.001 * full_turn, 1e-12);
}

TEST(WoundHandle, IsToldWhereTheCurveIsNoLongerC1) {
  // Leaving the middle key, squad-timed's handle is 10/2 · 10/11 of the turn, tcb's 10/3 · 10/11 of it.
  expect_the_limit("squad-timed", turn_and_rest, full_turn * 11.0 / 50.0);
  expect_the_limit("squad-timed", rest_and_turn, full_turn * 11.0 / 50.0);
  expect_the_limit("tcb", turn_and_rest, full_turn * 33.0 / 100.0);
  expect_the_limit("tcb", rest_and_turn, full_turn * 33.0 / 100.0);
  expect_the_limit("shoemake", rest_and_turn, full_turn * 33.0 / 100.0);
}

TEST(WoundHandle, OfShoemakeIsAlsoAContinuedStepThatWindsRound) {
  const double limit = full_turn / 10.0;  // continued ten times as long
  const auto rate = [](double turn) {
    return make_curve("shoemake", turn_and_rest(turn)).value().motion(1.0).angular_velocity.z();
  };
  const double below = 0.999 * limit, above = 1.001 * limit;
  EXPECT_FALSE(overwound_tangent("shoemake", turn_and_rest(below)).value());
  EXPECT_NEAR(rate(below), below * 10.0 / 11.0, 1e-12);
  const auto wound = overwound_tangent("shoemake", turn_and_rest(above)).value();
  ASSERT_TRUE(wound);
  EXPECT_EQ(wound->key, 1U);
  EXPECT_NEAR(wound->turn, 1.001 * full_turn, 1e-12);
  EXPECT_GT(std::abs(rate(above) - above * 10.0 / 11.0), 0.1);
}

TEST(WoundHandle, DependsOnTheParametersAndOnTheFamily) {
  const Keyframes keys = turn_and_rest(1.0);
  EXPECT_FALSE(overwound_tangent("tcb", keys).value());
  EXPECT_TRUE(overwound_tangent({"tcb", {.parameters = {{"tension", {-2.0}}}}}, keys).value());
  EXPECT_FALSE(overwound_tangent("timed-c1", turn_and_rest(3.0)).value());
  EXPECT_EQ(overwound_tangent("tcbb", keys).error().code, ErrorCode::bad_argument);
}

TEST(WoundHandle, OfASingleKeyIsNone) {
  const KeyframeData one{.times = {0.0}, .orientations = {Eigen::Quaterniond::Identity()}};
  for (const char* family : {"squad-timed", "tcb", "shoemake"})
    EXPECT_FALSE(overwound_tangent(family, keyframes(one)).value());
}

}}  // namespace orispline
