// SPDX-License-Identifier: Apache-2.0
// Keyframes at the door: what is refused and in which words, what is repaired and how it is counted.
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/track.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include <support/near.hpp>
#include <support/not_finite.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::near;
using testing_support::pi;

using testing_support::nan;
constexpr double infinity = std::numeric_limits<double>::infinity();

KeyframeData three_keys() {
  return {.times = {0.0, 1.0, 2.5},
          .orientations = {Eigen::Quaterniond::Identity(), exp<double>(Eigen::Vector3d(0.5, 0, 0)),
                           exp<double>(Eigen::Vector3d(0.5, 0.7, 0))},
          .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
          .angular_velocities = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}}};
}

struct BadKeys {
  const char* name;
  void (*spoil)(KeyframeData&);
  const char* message;  ///< as `describe` puts it
};

void PrintTo(const BadKeys& test, std::ostream* out) { *out << test.name; }

class KeyframesRefuse : public testing::TestWithParam<BadKeys> {};

TEST_P(KeyframesRefuse, WithTheKeyAndWhatWasWanted) {
  KeyframeData data = three_keys();
  GetParam().spoil(data);

  const auto keys = Keyframes::make(data);

  ASSERT_FALSE(keys);
  EXPECT_EQ(keys.error().code, ErrorCode::bad_data);
  EXPECT_EQ(describe(keys.error()), GetParam().message);
}

/// Two stretches of two keys, with half a turn at once between them.
KeyframeData keys_that_jump() {
  const auto turned = [](double angle) { return exp<double>(Eigen::Vector3d(angle, 0, 0)); };
  return {.times = {0.0, 1.0, 1.0, 2.5},
          .orientations = {turned(0.0), turned(0.5), turned(pi + 0.5), turned(pi + 1.0)},
          .jumps = true};
}

TEST(KeyframesThatJump, MayHaveTwoAtOneTime) {
  const auto keys = Keyframes::make(keys_that_jump());
  ASSERT_TRUE(keys) << describe(keys.error());
  EXPECT_TRUE(keys->data().jumps);
  EXPECT_TRUE(keys->with_times({0.0, 2.0, 2.0, 3.0})->data().jumps);
  EXPECT_FALSE(keys->with_times({0.0, 2.0, 2.5, 3.0})->data().jumps);
  EXPECT_FALSE(keys->first(2).data().jumps);
  EXPECT_EQ(keys->report().sign_flips + keys->report().near_half_turns, 0u);
  KeyframeData without = three_keys();
  without.jumps = true;
  EXPECT_FALSE(Keyframes::make(without)->data().jumps);
}

TEST(KeyframesThatJump, AreRefusedWithoutLeaveAndWithThreeAtOneTime) {
  KeyframeData data = keys_that_jump();
  data.jumps = false;
  EXPECT_EQ(describe(Keyframes::make(data).error()), "key 2: duplicate time 1, wanted strictly increasing times");
  data.jumps = true;
  data.times = {0.0, 1.0, 1.0, 1.0};
  EXPECT_EQ(describe(Keyframes::make(data).error()), "key 3: duplicate time 1, wanted strictly increasing times");
}

TEST(KeyframesThatJump, MayHaveStepsOfOtherSizesInEachStretch) {
  KeyframeData data = keys_that_jump();
  data.times = {0.0, 1.0, 1.0, 1.0 + 1e15};
  EXPECT_TRUE(Keyframes::make(data));
}

INSTANTIATE_TEST_SUITE_P(
    Bad, KeyframesRefuse,
    testing::Values(BadKeys{"NoKeys", [](KeyframeData& d) { d = {}; }, "empty: no keys"},
                    BadKeys{"FewerOrientations", [](KeyframeData& d) { d.orientations.pop_back(); },
                            "found 2 orientations for 3 times, wanted one per key"},
                    BadKeys{"FewerPositions", [](KeyframeData& d) { d.positions.resize(1); },
                            "found 1 positions for 3 times, wanted one per key"},
                    BadKeys{"MoreAngularVelocities",
                            [](KeyframeData& d) { d.angular_velocities.emplace_back(0, 0, 0); },
                            "found 4 angular velocities for 3 times, wanted one per key"},
                    BadKeys{"TimeNotANumber", [](KeyframeData& d) { d.times[1] = nan; },
                            "key 1: time is nan, wanted a finite number"},
                    BadKeys{"TimeInfinite", [](KeyframeData& d) { d.times[0] = -infinity; },
                            "key 0: time is -inf, wanted a finite number"},
                    BadKeys{"TimeTwice", [](KeyframeData& d) { d.times[2] = 1.0; },
                            "key 2: duplicate time 1, wanted strictly increasing times"},
                    BadKeys{"TimeBackwards", [](KeyframeData& d) { d.times[2] = 0.5; },
                            "key 2: time 0.5 comes after 1, wanted strictly increasing times"},
                    BadKeys{"QuaternionNotANumber", [](KeyframeData& d) { d.orientations[1].y() = nan; },
                            "key 1: the quaternion has a component that is not finite, wanted a unit quaternion"},
                    BadKeys{"QuaternionInfinite", [](KeyframeData& d) { d.orientations[0].w() = infinity; },
                            "key 0: the quaternion has a component that is not finite, wanted a unit quaternion"},
                    BadKeys{"QuaternionZero", [](KeyframeData& d) { d.orientations[2].coeffs().setZero(); },
                            "key 2: the quaternion has norm 0, wanted 1 within 0.001"},
                    BadKeys{"QuaternionFarFromUnit", [](KeyframeData& d) { d.orientations[1].coeffs() *= 1.5; },
                            "key 1: the quaternion has norm 1.5, wanted 1 within 0.001"},
                    BadKeys{"QuaternionOverflowing",
                            [](KeyframeData& d) { d.orientations[1].coeffs().setConstant(1e200); },
                            "key 1: the quaternion has norm 2e+200, wanted 1 within 0.001"},
                    BadKeys{"PositionNotANumber", [](KeyframeData& d) { d.positions[2].z() = nan; },
                            "key 2: the position has a component that is not finite, wanted finite numbers"},
                    BadKeys{"AngularVelocityInfinite", [](KeyframeData& d) { d.angular_velocities[1].x() = infinity; },
                            "key 1: the angular velocity has a component that is not finite, wanted finite numbers"},
                    BadKeys{"StepTooShort",
                            [](KeyframeData& d) {
                              d.times = {-1.0, 0.0, 0.9e-18};
                            },
                            "key 2: the step from time 0 to 9e-19 is 9e-19 s, wanted 1e-18 to 1e+18"},
                    BadKeys{"StepTooLong",
                            [](KeyframeData& d) {
                              d.times = {0.0, 2e18, 3e18};
                            },
                            "key 1: the step from time 0 to 2e+18 is 2e+18 s, wanted 1e-18 to 1e+18"},
                    BadKeys{"StepsTooUneven",
                            [](KeyframeData& d) {
                              d.times = {0.0, 1e-9, 2e5};
                            },
                            "key 2: the step from time 1e-09 to 200000 is 200000 s, and one of 1e-09 s is among the 5 "
                            "before it, wanted neither longer than 1e+14 times the other"},
                    BadKeys{"StepsTooUnevenBackwards",
                            [](KeyframeData& d) {
                              d.times = {-2e5, 0.0, 1e-9};
                            },
                            "key 2: the step from time 0 to 1e-09 is 1e-09 s, and one of 200000 s is among the 5 "
                            "before it, wanted neither longer than 1e+14 times the other"},
                    BadKeys{"PositionTooFar", [](KeyframeData& d) { d.positions[2].z() = -1.1e18; },
                            "key 2: the position has a component of 1.1e+18, wanted 1e+18 at most"},
                    BadKeys{"AngularVelocityTooLarge", [](KeyframeData& d) { d.angular_velocities[1].x() = 1e300; },
                            "key 1: the angular velocity has a component of 1e+300, wanted 1e+18 at most"},
                    BadKeys{"FewerInnerQuaternions",
                            [](KeyframeData& d) {
                              d.inner_leaving = {d.orientations[0], d.orientations[1]};
                            },
                            "found 2 leaving inner quaternions for 3 times, wanted one per key"},
                    BadKeys{"InnerQuaternionFarFromUnit",
                            [](KeyframeData& d) {
                              d.inner_arriving = d.orientations;
                              d.inner_arriving[2].coeffs() *= 1.5;
                            },
                            "key 2: the arriving inner quaternion has norm 1.5, wanted 1 within 0.001"},
                    BadKeys{"InnerQuaternionInfinite",
                            [](KeyframeData& d) {
                              d.inner_leaving = d.orientations;
                              d.inner_leaving[0].w() = infinity;
                            },
                            "key 0: the leaving inner quaternion has a component that is not finite, wanted a unit "
                            "quaternion"},
                    BadKeys{"InnerQuaternionInPart",
                            [](KeyframeData& d) {
                              d.inner_leaving.assign(3, free_inner());
                              d.inner_leaving[1].w() = 1.0;
                            },
                            "key 1: the leaving inner quaternion lacks 3 of its 4 components, wanted all of them, or "
                            "none to leave it free"}),
    [](const auto& test) { return std::string(test.param.name); });

/// Times with two steps so uneven that no method may see both, and so many keys between.
std::vector<double> uneven_times(std::size_t steps_between) {
  std::vector<double> times{0.0, 1e-9};
  for (std::size_t i = 0; i < steps_between; ++i) times.push_back(times.back() + 1.0);
  times.push_back(times.back() + 2e5);
  return times;
}

TEST(Keyframes, AreTooUnevenOnlyForStepsThatAMethodSeesTogether) {
  for (std::size_t between = 0; between <= 6; ++between) {
    const std::vector<double> times = uneven_times(between);
    const std::vector orientations(times.size(), Eigen::Quaterniond::Identity());
    EXPECT_EQ(Keyframes::make({.times = times, .orientations = orientations}).has_value(), between >= 5) << between;
    std::vector<double> even(times.size());
    for (std::size_t i = 0; i < even.size(); ++i) even[i] = static_cast<double>(i);
    const Keyframes keys = Keyframes::make({.times = even, .orientations = orientations}).value();
    EXPECT_EQ(keys.with_times(times).has_value(), between >= 5) << between;
  }
}

TEST(Keyframes, RatesOfAnotherSourceKeepTheirLimits) {
  const Keyframes keys = Keyframes::make(three_keys()).value();
  const std::vector<Eigen::Vector3d> rates(3, Eigen::Vector3d(1e18, 0, -1e18));
  EXPECT_TRUE(keys.with_rates(rates, rates, rates));
  EXPECT_FALSE(keys.with_rates(rates, rates, {{0, 0, 0}, {0, 2e18, 0}, {0, 0, 0}}));
}

TEST(Keyframes, AreNoneUnlessMade) {
  const Keyframes none;
  EXPECT_EQ(none.size(), 0u);
  EXPECT_TRUE(none.times().empty() && none.orientations().empty() && none.positions().empty());
  EXPECT_TRUE(none.angular_velocities().empty() && none.angular_accelerations().empty() &&
              none.angular_jerks().empty());
  EXPECT_EQ(none.report().sign_flips, 0u);
  EXPECT_EQ(describe(none.with_times({}).error()), "empty: no keys");
  EXPECT_FALSE(none.with_times({1.0}));
  EXPECT_EQ(Track{}.keys.size(), 0u);
}

TEST(Keyframes, KeepTheirKeysWhenTheyAreMovedFrom) {
  Keyframes keys = Keyframes::make(three_keys()).value();
  const Keyframes moved = std::move(keys);  // NOLINT
  ASSERT_EQ(keys.size(), 3u);               // NOLINT: that is what is tested
  EXPECT_EQ(keys.times()[2], moved.times()[2]);
  Keyframes assigned;
  assigned = std::move(keys);               // NOLINT
  EXPECT_EQ(keys.size(), assigned.size());  // NOLINT
}

TEST(Keyframes, TakeNormsOffByAThousandthAndNoMore) {
  const auto made = [](double norm) {
    KeyframeData data = three_keys();
    data.orientations[1].coeffs() *= norm;
    return Keyframes::make(std::move(data)).has_value();
  };
  for (const double norm : {0.999, 1.001}) EXPECT_TRUE(made(norm)) << norm;
  for (const double norm : {0.9989, 1.0011, 0.998, 1.002}) EXPECT_FALSE(made(norm)) << norm;
}

TEST(Keyframes, KeepWhatTheyAreGiven) {
  const KeyframeData data = three_keys();
  const Keyframes keys = Keyframes::make(data).value();
  ASSERT_EQ(keys.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(keys.times()[i], data.times[i]);
    EXPECT_TRUE(near(keys.orientations()[i], data.orientations[i], tolerance::exact));
    EXPECT_EQ(keys.positions()[i], data.positions[i]);
    EXPECT_EQ(keys.angular_velocities()[i], data.angular_velocities[i]);
  }
  EXPECT_EQ(keys.report().sign_flips, 0u);
  EXPECT_EQ(keys.report().non_unit_keys, 0u);
}

TEST(Keyframes, NormaliseAndCountQuaternionsNearlyUnit) {
  KeyframeData data = three_keys();
  data.orientations[1].coeffs() *= 1.0009;
  data.orientations[2].coeffs() *= 1.0 - 5e-7;  // within the rounding of float32 files: not worth counting

  const Keyframes keys = Keyframes::make(data).value();

  for (const auto& q : keys.orientations()) EXPECT_NEAR(q.norm(), 1.0, tolerance::exact);
  EXPECT_EQ(keys.report().non_unit_keys, 1u);
  EXPECT_NEAR(keys.report().largest_norm_error, 9e-4, 1e-12);
}

TEST(Keyframes, FlipSignsOneAfterTheOtherOnTheShortestWay) {
  KeyframeData data = three_keys();
  data.orientations[1].coeffs() *= -1.0;
  data.orientations[2].coeffs() *= -1.0;  // fits its neighbour as given, not after the neighbour's flip

  const Keyframes keys = Keyframes::make(data, Signs::shortest).value();

  EXPECT_EQ(keys.report().sign_flips, 1u);  // the file flips once, from key 0 to key 1
  for (std::size_t i = 1; i < 3; ++i) EXPECT_GT(keys.orientations()[i].dot(keys.orientations()[i - 1]), 0.0);
  EXPECT_TRUE(near(keys.orientations()[0], data.orientations[0], tolerance::exact));
}

TEST(Keyframes, CountStepsNearAHalfTurn) {
  const auto about_z = [](double angle) {
    return Eigen::Quaterniond(std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle));
  };
  const double margin = half_turn_margin, half = std::numbers::pi;
  KeyframeData data{.times = {0, 1, 2, 3, 4}, .orientations = {}};
  double angle = 0.0;
  for (const double step : {0.0, 1.0, half - 0.999 * margin, half + 0.999 * margin, half - 1.001 * margin})
    data.orientations.push_back(about_z(angle += step));
  const KeyframeReport report = Keyframes::make(data, Signs::shortest)->report();
  EXPECT_EQ(report.near_half_turns, 2u);
  EXPECT_EQ(report.first_near_half_turn, 1u);
  EXPECT_EQ(Keyframes::make(data, Signs::as_given)->report().near_half_turns, 0u);
}

TEST(Keyframes, LeaveSignsAsGivenOnRequest) {
  KeyframeData data = three_keys();
  data.orientations[1].coeffs() *= -1.0;
  const Keyframes keys = Keyframes::make(data, Signs::as_given).value();
  EXPECT_EQ(keys.report().sign_flips, 2u);  // to key 1 and back: counted, not mended
  EXPECT_LT(keys.orientations()[1].dot(keys.orientations()[0]), 0.0);
}

TEST(Keyframes, LeaveAStepOfExactlyHalfATurnAsItIs) {
  const KeyframeData there{.times = {0, 1},
                           .orientations = {Eigen::Quaterniond::Identity(), quaternion_wxyz(0.0, 0.0, 1.0, 0.0)}};
  KeyframeData back = there;
  back.orientations[1].coeffs() *= -1.0;
  EXPECT_EQ(Keyframes::make(there)->orientations()[1].y(), 1.0);
  EXPECT_EQ(Keyframes::make(back)->orientations()[1].y(), -1.0);
  EXPECT_EQ(Keyframes::make(back)->report().sign_flips, 0u);
}

TEST(Keyframes, StepsJustOverHalfATurnGoTheOtherWay) {
  const KeyframeData data{
      .times = {0, 1}, .orientations = {Eigen::Quaterniond::Identity(), exp<double>(Eigen::Vector3d(0, 0, pi + 1e-6))}};
  const Keyframes keys = Keyframes::make(data).value();
  const Eigen::Vector3d step = increment<double>(keys.orientations()[0], keys.orientations()[1]);
  EXPECT_TRUE(near(step, Eigen::Vector3d(0, 0, -(pi - 1e-6)), tolerance::algebra));
}

TEST(Keyframes, InnerQuaternionsAreUnitAndHaveTheSignThatIsNearerToTheirKey) {
  KeyframeData data = three_keys();
  data.inner_leaving = data.orientations;
  data.inner_leaving[1].coeffs() *= -1.0005;
  data.inner_leaving[2] = free_inner();
  const Keyframes keys = Keyframes::make(data).value();
  EXPECT_TRUE(near(keys.inner_leaving()[1], keys.orientations()[1], tolerance::exact));
  EXPECT_TRUE(is_free_inner(keys.inner_leaving()[2]));
  EXPECT_TRUE(keys.inner_arriving().empty() && keys.have_inner_quaternions());
  const Keyframes again = Keyframes::make(keys.data(), Signs::as_given).value();
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(again.inner_leaving()[i].coeffs(), keys.inner_leaving()[i].coeffs());
}

TEST(Keyframes, KeepInnerQuaternionsNearTheirKeysWhereSomeAreTaken) {
  KeyframeData data{.times = {0.0, 1.0, 2.0}};
  for (const double angle : {0.0, 2.0, 4.0}) data.orientations.push_back(exp<double>(Eigen::Vector3d(0, 0, angle)));
  data.inner_leaving = data.inner_arriving = data.orientations;
  const std::array<std::size_t, 2> ends{0, 2};
  const Keyframes some = Keyframes::make(std::move(data)).value().at(ends);
  EXPECT_LT(some.orientations()[1].w() * std::cos(2.0), 0.0);  // the short way from the first is the other one
  EXPECT_TRUE(near(some.inner_leaving()[1], some.orientations()[1], tolerance::exact));
  EXPECT_TRUE(near(some.inner_arriving()[1], some.orientations()[1], tolerance::exact));
  EXPECT_EQ(some.first(1).inner_arriving().size(), 1u);
}

TEST(Keyframes, AreNotGivenInnerQuaternionsThatAreAllFree) {
  KeyframeData data = three_keys();
  data.inner_leaving.assign(3, free_inner());
  EXPECT_FALSE(Keyframes::make(std::move(data)).value().have_inner_quaternions());
}

TEST(Keyframes, PositionsAndRatesAreOptional) {
  KeyframeData data = three_keys();
  data.positions.clear();
  data.angular_velocities.clear();
  const Keyframes keys = Keyframes::make(data).value();
  EXPECT_TRUE(keys.positions().empty());
  EXPECT_TRUE(keys.angular_velocities().empty());
}

}}  // namespace orispline
