// SPDX-License-Identifier: Apache-2.0
// The band of measured: agreement with the reference, and what its page promises.
#include <gtest/gtest.h>

#include <orispline/families/motion_band.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

MotionBand band_of(const KeyframeData& data, double share = 0.9) {
  return MotionBand::make("measured", Keyframes::make(data).value(), share).value();
}

TEST(MotionBand, AgreesWithTheReference) {
  const DataTable keys("golden/measured_keys.csv"), rows("golden/measured.csv");
  // Where the motion is smooth to 1e-8 rad or exact, what the band is made of is little more than rounding.
  constexpr double golden_band = 1e-9, rounding = 1e-13;
  std::size_t finite = 0;
  std::string name;
  std::vector<MotionBand> bands;
  for (const auto& row : rows.rows()) {
    if (row.text("sequence") != name) {
      name = row.text("sequence");
      KeyframeData data;
      for (const auto& key : keys.rows_where("sequence", name)) {
        data.times.push_back(key.number("t"));
        data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
      }
      bands = {band_of(data, 0.5), band_of(data, 0.9)};
    }
    for (const std::size_t k : {0u, 1u}) {
      const char* column = k == 0 ? "band50" : "band90";
      const double found = bands[k](row.number("t"));
      if (row.text(column).empty()) {
        EXPECT_EQ(found, std::numeric_limits<double>::infinity()) << name;
        continue;
      }
      const double wanted = row.number(column);
      EXPECT_NEAR(found, wanted, golden_band * wanted + rounding) << name << " at " << row.number("t");
      ++finite;
    }
  }
  EXPECT_GT(finite, 1000u);
}

TEST(MotionBand, IsTheSameBackwardsInTime) {
  const KeyframeData data = random_walk(931, 40, Spacing::uneven, 0.5);
  KeyframeData reversed;
  for (std::size_t i = data.times.size(); i-- > 0;) {
    reversed.times.push_back(-data.times[i]);
    reversed.orientations.push_back(data.orientations[i]);
  }
  const MotionBand forward = band_of(data), backward = band_of(reversed);
  for (std::size_t i = 0; i + 1 < data.times.size(); ++i)
    for (const double u : {0.1, 0.4, 0.6, 0.9}) {  // at a key that of the interval which begins there
      const double t = data.times[i] + u * (data.times[i + 1] - data.times[i]);
      EXPECT_NEAR(forward(t), backward(-t), tolerance::series * forward(t)) << t;
    }
}

TEST(MotionBand, GrowsWithTheShareAndBetweenTheKeys) {
  const KeyframeData data = random_walk(932, 40, Spacing::even, 0.5);
  const MotionBand half = band_of(data, 0.5), most = band_of(data, 0.99);
  for (std::size_t i = 0; i + 1 < data.times.size(); ++i) {
    const double middle = 0.5 * (data.times[i] + data.times[i + 1]);
    EXPECT_LT(half(middle), most(middle));
    EXPECT_LE(half(data.times[i]), half(middle));
  }
  EXPECT_EQ(half(data.times.front() - 1.0), half(data.times.front()));
  EXPECT_EQ(half(data.times.back() + 1.0), half(data.times.back()));
  EXPECT_TRUE(std::isnan(half(std::nan(""))));
}

TEST(MotionBand, IsInfiniteWhereTheKeysSayNothing) {
  for (const KeyframeData& data : {random_walk(933, 8, Spacing::even, 0.5), random_walk(934, 40, Spacing::even, 3.1)})
    EXPECT_EQ(band_of(data)(0.5 * (data.times[3] + data.times[4])), std::numeric_limits<double>::infinity());
}

TEST(MotionBand, RefusesSharesAndMethodsWithoutABand) {
  const Keyframes keys = keyframes(random_walk(935, 20, Spacing::even));
  for (const double share : {0.0, 1.0, -0.5, 90.0, std::nan("")}) {
    const auto band = MotionBand::make("measured", keys, share);
    ASSERT_FALSE(band) << share;
    EXPECT_EQ(band.error().code, ErrorCode::bad_argument);
  }
  const auto band = MotionBand::make("auto", keys, 0.9);
  ASSERT_FALSE(band);
  EXPECT_EQ(band.error().message, "method 'auto' has no band, wanted 'measured'");
}

}}  // namespace orispline
