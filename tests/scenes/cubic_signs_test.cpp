// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <orispline/clip/clip_motion.hpp>

#include "scenes/gltf_file.hpp"

namespace orispline::scenes { namespace {

using test::GltfFile;
using test::read;
using test::said_of;

/// Turns about z by 0°, 60° and 90° at 0, 1 and 2 s, at rest at each, of which the second may have the other sign.
std::string cubic(float sign) {
  GltfFile file;
  const float s = 0.5F, c = 0.8660254F, h = 0.70710677F;
  const std::vector<float> keys{0,        0,        0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                sign * s, sign * c, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, h, h, 0, 0, 0, 0};
  const std::size_t times = file.floats("SCALAR", {0, 1, 2});
  file.animate(times, file.floats("VEC4", keys), "CUBICSPLINE");
  return file.text();
}

double angle_at(const Scene& scene, double t) {
  const Eigen::Quaterniond q = ChannelCurve(scene.clips[0].rotations[0]).at(t);
  return angular_distance(q, Eigen::Quaterniond::Identity());
}

TEST(CubicSigns, ThatFlipAreSaidAndMended) {
  EXPECT_EQ(said_of(cubic(1)), "");
  const auto flipped = read(cubic(-1));
  ASSERT_TRUE(flipped);
  ASSERT_EQ(flipped->warnings.size(), 1u);
  const Warning& warning = flipped->warnings[0];
  EXPECT_EQ(warning.code, "cubic_signs");
  EXPECT_EQ(warning.number("steps"), 2.0);
  EXPECT_EQ(warning.where.key, 1u);
  EXPECT_EQ(warning.message,
            "clip 'walk', joint 'arm': 2 steps of cubic rotations, the first from key 0, go the long way round, as the "
            "signs of the quaternions say; if the short way is meant, set `signs` to shortest");
  const auto meant = read(cubic(1)), mended = read(cubic(-1), {.signs = Signs::shortest});
  EXPECT_TRUE(mended->warnings.empty());
  EXPECT_GT(std::abs(angle_at(*flipped, 0.5) - angle_at(*meant, 0.5)), 1.0);
  for (double t = 0; t <= 2; t += 0.125) EXPECT_NEAR(angle_at(*mended, t), angle_at(*meant, t), 1e-12) << t;
}

TEST(CubicSigns, AsGivenAreLeftWithoutAWord) {
  const auto as_given = read(cubic(-1), {.signs = Signs::as_given});
  EXPECT_TRUE(as_given->warnings.empty());
  EXPECT_EQ(angle_at(*as_given, 0.5), angle_at(*read(cubic(-1)), 0.5));
}

/// A turn about z by 300° in a second at an even rate, or with tangents that lead the other way.
std::string long_turn(float sense) {
  GltfFile file;
  const float rate = sense * 2.6179938F;
  const std::vector<float> keys{
      0, 0, rate, 0,           0, 0, 0, 1, 0, 0, rate, 0, 0, 0, -0.8660254F * rate, -0.5F * rate,
      0, 0, 0.5F, -0.8660254F, 0, 0, 0, 0};
  const std::size_t times = file.floats("SCALAR", {0, 1});
  file.animate(times, file.floats("VEC4", keys), "CUBICSPLINE");
  return file.text();
}

TEST(CubicSigns, OfALongTurnAreMeantWhereTheTangentsLeadThatWay) {
  EXPECT_EQ(said_of(long_turn(1)), "");
  EXPECT_NE(said_of(long_turn(-1)), "");
}

}}  // namespace orispline::scenes
