// SPDX-License-Identifier: Apache-2.0
// Contract: no frame, no sign, no unit of time and no direction of it is special, at rests neither.
#include <contract/family_contract.hpp>
#include <support/resting_keys.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

const Eigen::Quaterniond turn = exp<double>(Eigen::Vector3d(1.3, -2.1, 0.4));

/// Beside a rest a curve may turn back within a segment, by which rounding grows.
constexpr MotionTolerance same_motion_at_rests{1e-11, 1e-7, 1e-7, 1e-7};

/// With the rates that a clock sees that ticks so often [s].
Motion at_clock(double tick, Motion m) {
  m.angular_velocity *= tick;
  m.angular_acceleration *= tick * tick;
  m.angular_jerk *= tick * tick * tick;
  return m;
}

/// From knot to knot, on average [s].
double mean_step(const AnyCurve& curve) {
  const auto domain = curve.domain();
  return (domain.end - domain.start) / static_cast<double>(curve.knots().segments());
}

/// The sizes of its rates at a clock that ticks once a step.
RateSizes rate_sizes(const AnyCurve& curve) {
  RateSizes sizes;
  for (const double t : sample_times(curve.knots().times(), 5))
    sizes.include(at_clock(mean_step(curve), curve.motion(t)));
  return sizes;
}

/// A curve and what a change of its keys makes of it.
struct Changed {
  AnyCurve curve, changed;
  MotionTolerance allowed;
  RateSizes sizes = rate_sizes(curve);

  /// No unit of time is special to rounding either: it is judged at clocks that tick once a step. The orientation is
  /// the sum of the rates, and where these turn it far within a step it is known no better than they are.
  void require_same(const Motion& found, const Motion& wanted) const {
    MotionTolerance here = allowed;
    here.orientation *= sizes.velocity;
    require(near(at_clock(mean_step(changed), found), at_clock(mean_step(curve), wanted), here, sizes));
  }
};

class SymmetryContract : public FamilyContract {
 protected:
  /// A property of random keys and a change of them, and of such keys as rest. Those a method that solves equations may
  /// refuse.
  template <class... More, class Change, class Property>
  static void expect_of_all_keys(const std::string& name, const Change& change, const Property& property,
                                 Signs signs = Signs::as_given) {
    EXPECT_TRUE(holds(name, [&](const RandomKeys& random, More... more) {
      const KeyframeData data = fitting(GetParam(), random);
      property(Changed{curve(keyframes(data, signs)), curve(keyframes(change(data, more...), signs)), same_motion},
               more...);
    }));
    EXPECT_TRUE(holds(name + " at rests", [&](const RestingKeys& random, More... more) {
      const KeyframeData data = fitting(GetParam(), random);
      const auto first = make_curve(GetParam().name, keyframes(data, signs)),
                 second = make_curve(GetParam().name, keyframes(change(data, more...), signs));
      if (first && second) property(Changed{*first, *second, same_motion_at_rests}, more...);
      else RC_ASSERT(GetParam().is_global());
    }));
  }
};

KeyframeData with_orientations(KeyframeData data, const auto& changed) {
  for (Eigen::Quaterniond& q : data.orientations) q = changed(q);
  return data;
}

TEST_P(SymmetryContract, TurningTheWorldTurnsTheCurveAndLeavesBodyRates) {
  const auto change = [](const KeyframeData& data) {
    return with_orientations(data, [](const Eigen::Quaterniond& q) { return turn * q; });
  };
  expect_of_all_keys("left equivariance", change, [](const Changed& c) {
    for (const double t : times_on(c.curve)) {
      Motion wanted = c.curve.motion(t);
      wanted.orientation = turn * wanted.orientation;
      c.require_same(c.changed.motion(t), wanted);
    }
  });
}

TEST_P(SymmetryContract, TurningTheBodyTurnsTheBodyRates) {
  const auto change = [](const KeyframeData& data) {
    return with_orientations(data, [](const Eigen::Quaterniond& q) { return q * turn; });
  };
  expect_of_all_keys("right equivariance", change, [](const Changed& c) {
    for (const double t : times_on(c.curve)) {
      const Motion m = c.curve.motion(t);
      c.require_same(c.changed.motion(t), {.orientation = m.orientation * turn,
                                           .angular_velocity = to_body<double>(turn, m.angular_velocity),
                                           .angular_acceleration = to_body<double>(turn, m.angular_acceleration),
                                           .angular_jerk = to_body<double>(turn, m.angular_jerk)});
    }
  });
}

TEST_P(SymmetryContract, SignsOfTheKeysDoNotMatterOnTheShortestWay) {
  const auto flipped = [](KeyframeData data, std::uint8_t flips) {
    for (std::size_t i = 0; i < data.orientations.size(); ++i)
      if ((flips >> i) & 1) data.orientations[i].coeffs() *= -1.0;
    return data;
  };
  const auto property = [](const Changed& c, std::uint8_t flips) {
    const double sign = flips & 1 ? -1.0 : 1.0;  // the first key gives the sign to all
    for (const double t : times_on(c.curve)) {
      Motion wanted = c.curve.motion(t);
      wanted.orientation.coeffs() *= sign;
      c.require_same(c.changed.motion(t), wanted);
    }
  };
  expect_of_all_keys<std::uint8_t>("q and -q", flipped, property, Signs::shortest);
}

TEST_P(SymmetryContract, AnotherClockGivesTheSameCurveAtScaledRates) {
  const auto scale_of = [](bool faster) { return faster ? 0.25 : 3.0; };
  constexpr double shift = -7.5;
  const auto rescaled = [&](KeyframeData data, bool faster) {
    for (double& t : data.times) t = scale_of(faster) * t + shift;
    return data;
  };
  expect_of_all_keys<bool>("affine change of time", rescaled, [&](const Changed& c, bool faster) {
    for (const double t : times_on(c.curve, 4))
      c.require_same(c.changed.motion(scale_of(faster) * t + shift), c.curve.motion(t));
  });
}

/// The keys in the other order, at the times with the other sign.
KeyframeData reversed(const KeyframeData& data) {
  KeyframeData back;
  for (std::size_t i = data.times.size(); i-- > 0;) {
    back.times.push_back(-data.times[i]);
    back.orientations.push_back(data.orientations[i]);
  }
  return back;
}

/// How far the curve of the keys is from the one that runs through them backwards.
double distance_to_reverse(const AnyCurve& curve, const AnyCurve& back, std::span<const double> times) {
  double farthest = 0.0;
  for (const double t : times) farthest = std::max(farthest, relative_error(back(-t), curve(t)));
  return farthest;
}

/// A product of turns about the axes of one key after another has a direction. A method that has none has none on any
/// keys.
TEST_P(SymmetryContract, AMethodWithoutADirectionOfTimeHasNoneOnAnyKeys) {
  const KeyframeData plain = walk(22, 6, Spacing::uneven, 0.8);
  const AnyCurve forth = curve(keyframes(plain)), back = curve(keyframes(reversed(plain)));
  if (distance_to_reverse(forth, back, times_on(forth)) > tolerance::visible_jump) return;
  expect_of_all_keys("reversal", reversed, [](const Changed& c) {
    const double distance = distance_to_reverse(c.curve, c.changed, times_on(c.curve, 4));
    require(within(distance, 10.0 * c.allowed.orientation, "the way back"));
  });
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
