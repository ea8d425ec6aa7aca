// SPDX-License-Identifier: Apache-2.0
// Contract: no frame, no sign, no unit of time and no epoch is special, also where the body rests, and where keys are
// neighbours in the last bit. Nor is the direction of time, of the methods that it does not visibly matter to.
#include <functional>

#include <contract/family_contract.hpp>
#include <support/resting_keys.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

const Eigen::Quaterniond turn = exp<double>(Eigen::Vector3d(1.3, -2.1, 0.4));

/// Through rests: noise in the last bit of keys is divided by powers of their steps in time.
constexpr MotionTolerance nearly_same_motion{tolerance::series, tolerance::rates, HUGE_VAL, HUGE_VAL};

/// Other keys, and what becomes of a motion of the curve through those that they were, at what becomes of its time.
struct Change {
  KeyframeData keys;
  std::function<Motion(Motion)> of_motion = [](const Motion& m) { return m; };
  double time_scale = 1.0, time_shift = 0.0;
};

Change turned_world(KeyframeData keys) {
  for (auto& q : keys.orientations) q = turn * q;
  return {std::move(keys), [](Motion m) {
            m.orientation = turn * m.orientation;
            return m;
          }};
}

Change turned_body(KeyframeData keys) {
  for (auto& q : keys.orientations) q = q * turn;
  return {std::move(keys), [](const Motion& m) {
            return Motion{.orientation = m.orientation * turn,
                          .angular_velocity = to_body<double>(turn, m.angular_velocity),
                          .angular_acceleration = to_body<double>(turn, m.angular_acceleration),
                          .angular_jerk = to_body<double>(turn, m.angular_jerk)};
          }};
}

Change other_signs(KeyframeData keys, std::uint8_t flips) {
  for (std::size_t i = 0; i < keys.orientations.size(); ++i)
    if ((flips >> i) & 1) keys.orientations[i].coeffs() *= -1.0;
  const double sign = flips & 1 ? -1.0 : 1.0;  // the first key gives the sign to all
  return {std::move(keys), [sign](Motion m) {
            m.orientation.coeffs() *= sign;
            return m;
          }};
}

Change other_clock(KeyframeData keys, double scale, double shift) {
  for (double& t : keys.times) t = scale * t + shift;
  return {.keys = std::move(keys), .time_scale = scale, .time_shift = shift};
}

Change reversed(KeyframeData keys) {
  keys = other_clock(std::move(keys), -1.0, 0.0).keys;
  std::ranges::reverse(keys.times);
  std::ranges::reverse(keys.orientations);
  return {.keys = std::move(keys), .time_scale = -1.0};
}

/// With its rates at a clock that ticks so often [s].
Motion at_clock(double tick, Motion m) {
  m.angular_velocity *= tick;
  m.angular_acceleration *= tick * tick;
  m.angular_jerk *= tick * tick * tick;
  return m;
}

class SymmetryContract : public FamilyContract {
 protected:
  [[nodiscard]] static testing::AssertionResult are_same(const KeyframeData& data, const Change& change,
                                                         const MotionTolerance& allowed,
                                                         Signs signs = Signs::as_given) {
    const auto c = make_curve(GetParam().name, keyframes(data, signs));
    if (!c && may_refuse(GetParam())) return testing::AssertionSuccess();
    const auto d = make_curve(GetParam().name, keyframes(change.keys, signs));
    if (!d && may_refuse(GetParam())) return testing::AssertionSuccess();
    if (!c || !d) return testing::AssertionFailure() << describe(c ? d.error() : c.error());
    // No unit of time is special to a tolerance either: the clock ticks once from key to key, on average.
    const double tick = (data.times.back() - data.times.front()) / static_cast<double>(data.times.size() - 1);
    const Side side = change.time_scale < 0.0 ? Side::left : Side::right;
    for (const double t : times_on(*c, change.time_scale == 1.0 ? 5 : 4)) {
      const Motion found = d->motion(change.time_scale * t + change.time_shift, side);
      const auto same =
          near(at_clock(change.time_scale * tick, found), change.of_motion(at_clock(tick, c->motion(t))), allowed);
      if (!same) return testing::AssertionResult(same) << " at t = " << t;
    }
    return testing::AssertionSuccess();
  }

  /// On random keys, and on those with rests among them.
  template <class... Random>
  static void expect_same(const std::string& name, auto&& change, Signs signs = Signs::as_given) {
    const auto property = [&](const RandomKeys& random, const MotionTolerance& allowed, Random... more) {
      const KeyframeData data = fitting(GetParam(), random);
      require(are_same(data, change(data, more...), allowed, signs));
    };
    EXPECT_TRUE(holds(name, [&](const RandomKeys& keys, Random... more) { property(keys, same_motion, more...); }));
    EXPECT_TRUE(holds(name + " through rests",
                      [&](const RestingKeys& keys, Random... more) { property(keys, nearly_same_motion, more...); }));
  }

  /// Whether curves through reversed keys are others: visibly so, on walks that are even and uneven by turns.
  [[nodiscard]] static bool has_a_direction_of_time() {
    constexpr MotionTolerance visibly{tolerance::visible_jump, HUGE_VAL, HUGE_VAL, HUGE_VAL};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const KeyframeData data = walk(seed, 6, seed % 2 == 0 ? Spacing::even : Spacing::uneven, 1.0);
      if (!are_same(data, reversed(data), visibly)) return true;
    }
    return false;
  }
};

TEST_P(SymmetryContract, TurningTheWorldTurnsTheCurveAndLeavesBodyRates) {
  expect_same("left equivariance", turned_world);
}

TEST_P(SymmetryContract, TurningTheBodyTurnsTheBodyRates) { expect_same("right equivariance", turned_body); }

TEST_P(SymmetryContract, SignsOfTheKeysDoNotMatterOnTheShortestWay) {
  expect_same<std::uint8_t>("q and -q", other_signs, Signs::shortest);
}

TEST_P(SymmetryContract, AnotherClockGivesTheSameCurveAtScaledRates) {
  expect_same<bool>("affine change of time",
                    [](const KeyframeData& data, bool faster) { return other_clock(data, faster ? 0.25 : 3.0, -7.5); });
}

TEST_P(SymmetryContract, WithoutADirectionOfTimeReversedKeysGiveTheReversedCurve) {
  if (has_a_direction_of_time()) {
    EXPECT_NE(GetParam().name, default_method);
    return;
  }
  const auto property = [](const RandomKeys& random) {
    const KeyframeData data = fitting(GetParam(), random);
    require(are_same(data, reversed(data), nearly_same_motion));
  };
  EXPECT_TRUE(holds("reversal", [&](const RandomKeys& keys) { property(keys); }));
  EXPECT_TRUE(holds("reversal through rests", [&](const RestingKeys& keys) { property(keys); }));
}

TEST_P(SymmetryContract, EpochOfUnixTimeChangesNothing) {
  KeyframeData data = walk(21, 6, Spacing::uneven);
  for (double& t : data.times) t = std::round(t * 64.0) / 64.0;  // exact, also when shifted
  const double epoch = 1.7e9;
  KeyframeData later = data;
  for (double& t : later.times) t += epoch;
  const Keyframes keys = keyframes(data);
  const AnyCurve c = curve(keys), d = curve(keyframes(later));
  for (double t = keys.times().front(); t <= keys.times().back(); t += 1.0 / 128.0)
    EXPECT_TRUE(near(d.motion(t + epoch), c.motion(t), {0.0, 0.0, 0.0, 0.0})) << t;
}

ORISPLINE_FOR_EVERY_FAMILY(SymmetryContract);

}}  // namespace orispline::contract
