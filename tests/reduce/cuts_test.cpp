// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <reduce/recorded_walk.hpp>
#include <reduce/reduced_clip.hpp>

namespace orispline { namespace {

using testing_support::degree;
using testing_support::reduced_clip;

constexpr double cut_time = 2.0;

/// A camera that turns and goes along, and from the cut on does so elsewhere.
Eigen::Quaterniond turned(double t, bool is_after) {
  const Eigen::Vector3d turn(0.3 * std::sin(t), 0.2 * std::cos(1.3 * t), 0.1 * t);
  return exp<double>(Eigen::Vector3d(0.0, is_after ? 2.5 : 0.0, 0.0)) * exp<double>(turn);
}
Eigen::Vector3d placed(double t, bool is_after) {
  return Eigen::Vector3d(std::sin(0.8 * t), 0.4 * t, 0.0) +
         (is_after ? Eigen::Vector3d(40, 0, -9) : Eigen::Vector3d(0, 0, 0));
}

/// At 30 Hz. The last key before the cut is so long before its end.
Clip camera(double length_of_cut, bool does_move = true) {
  Clip clip{.name = "shot", .rotations = {{.joint = 0}}, .translations = {{.joint = 0}}};
  const auto add = [&](double t, bool is_after) {
    clip.rotations[0].times.push_back(t);
    clip.rotations[0].values.push_back(turned(t, is_after));
    clip.translations[0].times.push_back(t);
    clip.translations[0].values.push_back(placed(t, is_after && does_move));
  };
  for (int i = 0; i < 120; ++i) {
    if (i == 60 && length_of_cut < 0.03) add(cut_time - length_of_cut, false);
    add(i / 30.0, i >= 60);
  }
  return clip;
}

Skeleton one_camera() { return Skeleton::make({{.name = "camera"}}).value(); }

ClipReduceOptions options(BetweenSamples between, Cuts cuts) {
  return {.tolerance = 0.2 * degree, .position_tolerance = 0.005, .between = between, .cuts = cuts};
}

/// How far it is from what was filmed on either side of the cut [rad], [m]; `until`: where the side before ends.
struct Off {
  double angle = 0.0, length = 0.0;
};
Off farthest_off(const Clip& clip, double until, bool does_move = true) {
  const ChannelCurve<Eigen::Quaterniond> rotation(clip.rotations[0]);
  const ChannelCurve<Eigen::Vector3d> translation(clip.translations[0]);
  Off off;
  for (double t = 0.0; t < 119 / 30.0; t += 0.0017) {
    if (t > until && t < cut_time) continue;
    off.angle = std::max(off.angle, angular_distance(rotation.at(t), turned(t, t >= cut_time)));
    off.length = std::max(off.length, (translation.at(t) - placed(t, does_move && t >= cut_time)).norm());
  }
  return off;
}

TEST(Cuts, BetweenCloseKeysNothingSwingsOnEitherSide) {
  for (const auto between : {BetweenSamples::stored, BetweenSamples::smooth})
    for (const char* method : {"cubicspline", "hermite-c1", "auto"}) {
      ClipReduceOptions how = options(between, Cuts::usual);
      how.method = {method};
      const Clip clip = camera(0.001);
      const ClipReduction found = reduced_clip(one_camera(), clip, how);
      SCOPED_TRACE(method);
      EXPECT_EQ(found.cuts, 1u);
      const Off off = farthest_off(found.clip, cut_time - 0.001);
      EXPECT_LT(off.angle, 0.25 * degree);
      EXPECT_LT(off.length, 0.0055);
      EXPECT_LT(found.rotation_keys, clip.rotations[0].size());
    }
}

TEST(Cuts, OfOneStepAreHeldUntilShortlyBeforeItsEnd) {
  const Clip clip = camera(1 / 30.0);
  for (const auto& how : {options(BetweenSamples::smooth, Cuts::usual), options(BetweenSamples::stored, Cuts::steps)}) {
    const ClipReduction found = reduced_clip(one_camera(), clip, how);
    EXPECT_EQ(found.cuts, 1u);
    EXPECT_LT(found.rotation_keys, 40u);
    const Off off = farthest_off(found.clip, cut_time - 1 / 30.0);
    EXPECT_LT(off.angle, 0.25 * degree);
    EXPECT_LT(off.length, 0.0055);
    const ChannelCurve<Eigen::Quaterniond> rotation(found.clip.rotations[0]);
    EXPECT_LT(angular_distance(rotation.at(cut_time - 0.0011), turned(cut_time - 1 / 30.0, false)), 0.25 * degree);
  }
}

TEST(Cuts, OfOneChannelPartTheOthersOfTheJoint) {
  const Clip clip = camera(1 / 30.0, false);
  const ClipReduction found = reduced_clip(one_camera(), clip, options(BetweenSamples::smooth, Cuts::usual));
  EXPECT_EQ(found.cuts, 1u);
  const auto& times = found.clip.translations[0].times;
  EXPECT_NE(std::ranges::find(times, clip.translations[0].times[60]), times.end()) << "a key where the new shot begins";
}

TEST(Cuts, AreNotTakenWhereTheyAreNotAskedFor) {
  EXPECT_EQ(reduced_clip(one_camera(), camera(0.001), options(BetweenSamples::stored, Cuts::none)).cuts, 0u);
  const Clip ramp = camera(1 / 30.0);
  const ClipReduction found = reduced_clip(one_camera(), ramp, options(BetweenSamples::stored, Cuts::usual));
  EXPECT_EQ(found.cuts, 0u) << "a straight line from frame to frame is what the file says";
  const ChannelCurve<Eigen::Vector3d> before(ramp.translations[0]), after(found.clip.translations[0]);
  for (double t = 1.9; t < 2.1; t += 0.0003) EXPECT_LE((before.at(t) - after.at(t)).norm(), 0.005) << t;
}

TEST(Cuts, AreNotInMotionThatIsFast) {
  Clip clip{.name = "throw", .rotations = {{.joint = 0}}};
  for (int i = 0; i < 90; ++i) {
    const double t = i / 30.0, swing = 1.6 * std::tanh(12.0 * (t - 1.5));  // by up to 36° a step
    clip.rotations[0].times.push_back(t);
    clip.rotations[0].values.push_back(exp<double>(Eigen::Vector3d(swing, 0.0, 0.0)));
  }
  EXPECT_EQ(reduced_clip(one_camera(), clip, options(BetweenSamples::smooth, Cuts::usual)).cuts, 0u);
  for (double& time : clip.rotations[0].times) time /= 40.0;  // keys less than a millisecond apart
  EXPECT_EQ(reduced_clip(one_camera(), clip, options(BetweenSamples::stored, Cuts::usual)).cuts, 0u);
}

TEST(Cuts, AtLateTimesStayWhereTheFileCanHoldThem) {
  Clip clip = camera(1 / 30.0);
  for (double& time : clip.rotations[0].times) time += 20000.0;  // floats are 2 ms apart there
  for (double& time : clip.translations[0].times) time += 20000.0;
  ClipReduceOptions how = options(BetweenSamples::smooth, Cuts::usual);
  how.precision = KeyPrecision::float32;
  const ClipReduction found = reduced_clip(one_camera(), clip, how);
  EXPECT_EQ(found.cuts, 1u);
  const Clip stored = as_stored(found.clip, how);
  for (std::size_t i = 1; i < stored.rotations[0].size(); ++i)
    EXPECT_LT(static_cast<float>(stored.rotations[0].times[i - 1]), static_cast<float>(stored.rotations[0].times[i]));
}

}}  // namespace orispline
