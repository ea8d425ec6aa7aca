// SPDX-License-Identifier: Apache-2.0
// Contract: no frame, no sign and no unit of time is special.
#include <contract/family_contract.hpp>
#include <support/properties.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

const Eigen::Quaterniond turn = exp<double>(Eigen::Vector3d(1.3, -2.1, 0.4));

class SymmetryContract : public FamilyContract {};

TEST_P(SymmetryContract, TurningTheWorldTurnsTheCurveAndLeavesBodyRates) {
  EXPECT_TRUE(holds("left equivariance", [](const RandomKeys& random) {
    const KeyframeData data = fitting(GetParam(), random);
    KeyframeData turned = data;
    for (auto& q : turned.orientations) q = turn * q;
    const AnyCurve c = curve(keyframes(data)), d = curve(keyframes(turned));
    for (const double t : times_on(c)) {
      Motion wanted = c.motion(t);
      wanted.orientation = turn * wanted.orientation;
      require(near(d.motion(t), wanted, same_motion));
    }
  }));
}

TEST_P(SymmetryContract, TurningTheBodyTurnsTheBodyRates) {
  EXPECT_TRUE(holds("right equivariance", [](const RandomKeys& random) {
    const KeyframeData data = fitting(GetParam(), random);
    KeyframeData turned = data;
    for (auto& q : turned.orientations) q = q * turn;
    const AnyCurve c = curve(keyframes(data)), d = curve(keyframes(turned));
    for (const double t : times_on(c)) {
      const Motion m = c.motion(t);
      require(near(d.motion(t),
                   {.orientation = m.orientation * turn,
                    .angular_velocity = to_body<double>(turn, m.angular_velocity),
                    .angular_acceleration = to_body<double>(turn, m.angular_acceleration),
                    .angular_jerk = to_body<double>(turn, m.angular_jerk)},
                   same_motion));
    }
  }));
}

TEST_P(SymmetryContract, SignsOfTheKeysDoNotMatterOnTheShortestWay) {
  EXPECT_TRUE(holds("q and -q", [](const RandomKeys& random, std::uint8_t flips) {
    const KeyframeData data = fitting(GetParam(), random);
    KeyframeData flipped = data;
    for (std::size_t i = 0; i < flipped.orientations.size(); ++i)
      if ((flips >> i) & 1) flipped.orientations[i].coeffs() *= -1.0;
    const AnyCurve c = curve(keyframes(data, Signs::shortest)), d = curve(keyframes(flipped, Signs::shortest));
    const double sign = flips & 1 ? -1.0 : 1.0;  // the first key gives the sign to all
    for (const double t : times_on(c)) {
      Motion wanted = c.motion(t);
      wanted.orientation.coeffs() *= sign;
      require(near(d.motion(t), wanted, same_motion));
    }
  }));
}

TEST_P(SymmetryContract, AnotherClockGivesTheSameCurveAtScaledRates) {
  EXPECT_TRUE(holds("affine change of time", [](const RandomKeys& random, bool faster) {
    const double scale = faster ? 0.25 : 3.0, shift = -7.5;
    const KeyframeData data = fitting(GetParam(), random);
    KeyframeData rescaled = data;
    for (double& t : rescaled.times) t = scale * t + shift;
    const AnyCurve c = curve(keyframes(data)), d = curve(keyframes(rescaled));
    for (const double t : times_on(c, 4)) {
      const Motion m = c.motion(t), found = d.motion(scale * t + shift);
      require(near(found,
                   {.orientation = m.orientation,
                    .angular_velocity = m.angular_velocity / scale,
                    .angular_acceleration = m.angular_acceleration / (scale * scale),
                    .angular_jerk = m.angular_jerk / (scale * scale * scale)},
                   same_motion));
    }
  }));
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
