// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { namespace {

/// Keys 0.1 s apart, without those from 3 s to 5 s.
Keyframes interrupted() {
  KeyframeData data;
  for (int k = 0; k <= 80; ++k) {
    const double t = 0.1 * k;
    if (t > 3.05 && t < 4.95) continue;
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(std::sin(7.0 * t), std::cos(5.0 * t), 0.3 * t)));
  }
  return Keyframes::make(std::move(data)).value();
}

const std::vector<Stretch> both{{0, 31}, {31, 31}};

TEST(BandInStretches, IsThatOfTheKeysOfEachAndNoneBetween) {
  const Keyframes keys = interrupted();
  const auto band = BandInStretches::make("measured", keys, both, 0.9);
  ASSERT_TRUE(band) << describe(band.error());
  for (const Stretch& stretch : both) {
    const Keyframes own = keys_of_stretch(keys, stretch).value();
    const MotionBand alone = MotionBand::make("measured", own, 0.9).value();
    for (double t = own.times().front(); t <= own.times().back(); t += 0.013) EXPECT_EQ((*band)(t), alone(t)) << t;
  }
  EXPECT_TRUE(std::isnan((*band)(3.01)) && std::isnan((*band)(4.99)));
  EXPECT_EQ((*band)(-1.0), (*band)(0.0));
  EXPECT_EQ((*band)(9.0), (*band)(keys.times().back()));
}

TEST(BandInStretches, IsTheBandOfAllKeysWithoutStretches) {
  const Keyframes keys = interrupted();
  const auto band = BandInStretches::make("measured", keys, {}, 0.9);
  const MotionBand whole = MotionBand::make("measured", keys, 0.9).value();
  ASSERT_TRUE(band);
  for (double t = 0.0; t <= 8.0; t += 0.037) EXPECT_EQ((*band)(t), whole(t)) << t;
}

TEST(BandInStretches, RefusesWhatTheBandRefuses) {
  EXPECT_FALSE(BandInStretches::make("auto", interrupted(), both, 0.9));
  EXPECT_FALSE(BandInStretches::make("measured", interrupted(), both, 1.0));
}

}}  // namespace orispline
