// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <numeric>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <reduce/recorded_walk.hpp>
#include <reduce/reduced_clip.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using testing_support::degree;
using testing_support::reduced_clip;

Eigen::Quaterniond about_z(double angle) { return {std::cos(angle / 2), 0.0, 0.0, std::sin(angle / 2)}; }

/// Shoulder, elbow and hand along x, of lengths 0.3 and 0.25 m.
Skeleton arm() {
  JointPose elbow, hand;
  elbow.translation = {0.3, 0, 0};
  elbow.rotation = about_z(0.4);
  hand.translation = {0.25, 0, 0};
  return Skeleton::make({{.name = "shoulder"},
                         {.name = "elbow", .parent = 0, .rest = elbow},
                         {.name = "hand", .parent = 1, .rest = hand}})
      .value();
}

/// Smooth turns with a little noise at 30 Hz, as linear channels.
RotationChannel recorded_turns(std::size_t joint, std::size_t count, double noise) {
  testing_support::Dice dice(joint + 17);
  RotationChannel channel{.joint = joint};
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / 30.0;
    const Eigen::Vector3d turn(std::sin(2.0 * t), 0.7 * std::sin(1.3 * t + 1.0), std::cos(3.1 * t));
    channel.times.push_back(t);
    channel.values.push_back(exp<double>(turn) * exp<double>(Eigen::Vector3d(noise * dice.vector())));
  }
  return channel;
}

VectorChannel shifted(std::size_t count) {
  VectorChannel channel{.joint = 0};
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / 30.0;
    channel.times.push_back(t);
    channel.values.emplace_back(std::sin(t), 0.4 * t, 0.2 * std::cos(2.5 * t));
  }
  return channel;
}

Clip swing(double noise = 1e-3) {
  return {.name = "swing",
          .rotations = {recorded_turns(0, 150, noise), recorded_turns(1, 120, noise), recorded_turns(2, 90, noise)},
          .translations = {shifted(150)}};
}

ClipReduction reduced_arm(const Clip& clip, const ClipReduceOptions& options, const Skeleton& skeleton = arm()) {
  return reduced_clip(skeleton, clip, options);
}

double apart(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return angular_distance(a, b); }
double apart(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm(); }

/// At the keys before [rad, or a length].
template <CurvePoint P>
double farthest_at_keys(const Channel<P>& before, const Channel<P>& after) {
  const ChannelCurve<P> curve(after);
  double farthest = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i)
    farthest = std::max(farthest, apart(before.values[i], curve.at(before.times[i])));
  return farthest;
}

/// With twelve times between two of them.
std::vector<double> dense(const std::vector<double>& times) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    for (int k = 0; k < 13; ++k) all.push_back(times[i] + k / 13.0 * (times[i + 1] - times[i]));
  all.push_back(times.back());
  return all;
}

double largest_shell_distance(const Skeleton& skeleton, const Clip& before, const Clip& after, double shell) {
  std::vector<std::size_t> same(skeleton.size());
  std::iota(same.begin(), same.end(), std::size_t{0});
  double largest = 0.0;
  for (const JointDifference& joint :
       differences(ClipMotion(skeleton, before), ClipMotion(skeleton, after), same, dense(key_times(before)), shell))
    largest = std::max(largest, joint.distance.value);
  return largest;
}

bool is_float(double number) { return number == static_cast<double>(static_cast<float>(number)); }

TEST(ReduceClips, HoldsTheToleranceAtEveryKeyInEitherPrecisionByAnyMethod) {
  const Clip clip = swing();
  for (const char* method : {"cubicspline", "slerp", "auto", "timed-c2"})
    for (const auto precision : {KeyPrecision::float64, KeyPrecision::float32})
      for (const double tolerance : {0.05 * degree, 1.0 * degree}) {
        const ClipReduction found = reduced_arm(clip, {.tolerance = tolerance,
                                                       .position_tolerance = 0.01,
                                                       .method = {method},
                                                       .between = BetweenSamples::smooth,
                                                       .precision = precision});
        for (std::size_t i = 0; i < clip.rotations.size(); ++i) {
          const RotationChannel& channel = found.clip.rotations[i];
          EXPECT_LE(farthest_at_keys(clip.rotations[i], channel), tolerance) << method;
          EXPECT_EQ(channel.joint, i);
          EXPECT_EQ(channel.interpolation, std::string_view(method) == "slerp" ? ChannelInterpolation::linear
                                                                               : ChannelInterpolation::cubicspline);
          for (std::size_t k = 1; k < channel.size(); ++k)
            EXPECT_GE(channel.values[k].dot(channel.values[k - 1]), 0.0) << method;
        }
        EXPECT_LE(farthest_at_keys(clip.translations[0], found.clip.translations[0]), 0.01) << method;
        EXPECT_LE(found.angle.largest.value, tolerance);
      }
}

TEST(ReduceClips, HasFewerKeysWithCubicsAndCountsThem) {
  const Clip clip = swing();
  const ClipReduction cubic = reduced_arm(clip, {.tolerance = 0.5 * degree}),
                      linear = reduced_arm(clip, {.tolerance = 0.5 * degree, .method = {"slerp"}});
  EXPECT_EQ(cubic.rotation_tracks, 3u);
  EXPECT_EQ(cubic.open_tracks, 3u);
  EXPECT_EQ(cubic.rotation_keys_before, 360u);
  EXPECT_LT(cubic.rotation_keys, linear.rotation_keys / 2);
  std::size_t keys = 0;
  for (const RotationChannel& channel : cubic.clip.rotations) keys += channel.size();
  EXPECT_EQ(cubic.rotation_keys, keys);
  EXPECT_EQ(cubic.translation_keys, 150u) << "without a tolerance for them";
}

TEST(ReduceClips, StoresTheNumbersOfTheFile) {
  const ClipReduction found = reduced_arm(swing(), {.tolerance = 0.2 * degree, .precision = KeyPrecision::float32});
  for (const RotationChannel& channel : found.clip.rotations)
    for (std::size_t k = 0; k < channel.size(); ++k) {
      EXPECT_TRUE(is_float(channel.times[k]));
      EXPECT_TRUE(is_float(channel.in_tangents[k].x()));
      EXPECT_NEAR(channel.values[k].norm(), 1.0, 1e-15);
    }
}

TEST(ReduceClips, IsTheSameOnAnyNumberOfThreads) {
  const std::array clips{swing(), swing(5e-3), swing(0.0)};
  const ClipReduceOptions options{.tolerance = 1.0 * degree, .world_tolerance = 0.004};
  const auto one = reduce_clips(arm(), clips, options, 1).value(), two = reduce_clips(arm(), clips, options, 2).value();
  for (std::size_t i = 0; i < clips.size(); ++i) {
    EXPECT_EQ(one[i].distance.largest.value, two[i].distance.largest.value);
    for (std::size_t k = 0; k < 3; ++k) {
      const RotationChannel &a = one[i].clip.rotations[k], &b = two[i].clip.rotations[k];
      ASSERT_EQ(a.times, b.times);
      for (std::size_t key = 0; key < a.size(); ++key) {
        EXPECT_EQ(a.values[key].coeffs(), b.values[key].coeffs());
        EXPECT_EQ(a.out_tangents[key].coeffs(), b.out_tangents[key].coeffs());
      }
    }
  }
}

TEST(ReduceClips, HoldsTheDistanceInTheWorld) {
  const Skeleton skeleton = arm();
  for (const double noise : {0.0, 2e-3, 2e-2})
    for (const double length : {0.001, 0.01, 0.1}) {
      const Clip clip = swing(noise);
      const ClipReduction found = reduced_arm(clip, {.world_tolerance = length, .shell = 0.05}, skeleton);
      const double distance = largest_shell_distance(skeleton, clip, found.clip, 0.05);
      EXPECT_LE(distance, length);
      EXPECT_GE(found.distance.largest.value, distance * (1.0 - 1e-9)) << "no time is farther off than it says";
      EXPECT_LE(found.distance.largest.value, length);
      EXPECT_LE(found.rotation_keys, found.rotation_keys_before);
    }
  const Clip clip = swing();
  const ClipReduction found = reduced_arm(clip, {.world_tolerance = 0.01}, skeleton);
  EXPECT_LT(found.rotation_keys, 100u);
  EXPECT_GT(found.distance.largest.value, 0.005) << "the length is used";
}

TEST(ReduceClips, MakesOneKeyOfChannelsThatRest) {
  const Skeleton skeleton = arm();
  const auto still = [](std::size_t joint, const Eigen::Quaterniond& value, double rounding) {
    RotationChannel channel{.joint = joint};
    for (int i = 0; i < 10; ++i) {
      channel.times.push_back(0.5 + i);
      channel.values.push_back(value * about_z(i % 2 ? rounding : 0.0));
    }
    return channel;
  };
  Clip clip{.name = "still",
            .rotations = {still(0, about_z(0.7), 1e-6), still(1, about_z(0.4), 1e-6), still(2, about_z(0.0), 1e-3)}};
  clip.scales.push_back({.joint = 1, .times = {0.0, 1.0}, .values = {{1, 1, 1}, {1, 1, 1}}});
  const ClipReduction found = reduced_arm(clip, {.tolerance = 1e-4 * degree, .keep_constant = true}, skeleton);
  const auto& [other, rest, moving] =
      std::tie(found.clip.rotations[0], found.clip.rotations[1], found.clip.rotations[2]);
  ASSERT_EQ(other.size(), 1u);
  EXPECT_EQ(other.values[0].coeffs(), clip.rotations[0].values[0].coeffs());
  ASSERT_EQ(rest.size(), 1u);
  EXPECT_EQ(rest.values[0].coeffs(), skeleton[1].rest.rotation.coeffs());
  EXPECT_EQ(moving.size(), 10u);
  EXPECT_EQ(found.clip.scales[0].size(), 1u);
}

TEST(ReduceClips, KeepsASplineThatSwingsBetweenEqualKeys) {
  const Eigen::Quaterniond none(0, 0, 0, 0), up(0, 0, 0, 0.5), down(0, 0, 0, -0.5);
  const Clip clip{.name = "c",
                  .rotations = {{.interpolation = ChannelInterpolation::cubicspline,
                                 .times = {0.0, 1.0, 2.0},
                                 .values = {about_z(0), about_z(0), about_z(0)},
                                 .in_tangents = {none, down, down},
                                 .out_tangents = {up, up, none}}}};
  const ClipReduction found = reduced_arm(clip, {.tolerance = 0.1 * degree});
  const ChannelCurve<Eigen::Quaterniond> before(clip.rotations[0]), after(found.clip.rotations[0]);
  EXPECT_GT(apart(before.at(0.5), about_z(0)), 5 * degree);
  for (const double t : {0.2, 0.5, 0.9, 1.5}) EXPECT_LT(apart(before.at(t), after.at(t)), 0.2 * degree);
}

TEST(ReduceClips, LeavesStepsAndShortTracksAsTheyAre) {
  const Clip clip{.name = "c",
                  .rotations = {{.joint = 0,
                                 .interpolation = ChannelInterpolation::step,
                                 .times = {0.0, 1.0, 2.0, 3.0},
                                 .values = {about_z(0), about_z(0), about_z(1), about_z(1)}},
                                {.joint = 1, .times = {0.0, 3.0}, .values = {about_z(0), about_z(2)}},
                                {.joint = 2, .times = {1.0}, .values = {about_z(1)}}}};
  const ClipReduction found = reduced_arm(clip, {.tolerance = 5 * degree, .world_tolerance = 0.1});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(found.clip.rotations[i].interpolation, clip.rotations[i].interpolation);
    EXPECT_EQ(found.clip.rotations[i].times, clip.rotations[i].times);
  }
  EXPECT_EQ(found.angle.largest.value, 0.0);
}

TEST(ReduceClips, KeepsEveryHalfTurnOfASpin) {
  RotationChannel spin{.joint = 0};
  for (int i = 0; i <= 200; ++i) {
    spin.times.push_back(i / 30.0);
    spin.values.push_back(about_z(i * 9.0 * degree));
    if (i % 4 == 1) spin.values.back().coeffs() *= -1.0;
  }
  const Clip clip{.name = "spin", .rotations = {spin}};
  for (const char* method : {"cubicspline", "hermite-c1", "slerp", "auto"}) {
    const RotationChannel found =
        reduced_arm(clip, {.tolerance = 3 * degree, .method = {method}, .precision = KeyPrecision::float32})
            .clip.rotations[0];
    EXPECT_LE(farthest_at_keys(spin, found), 3 * degree) << method;
    EXPECT_GE(found.size(), 11u) << method;
    for (std::size_t k = 1; k < found.size(); ++k) {
      EXPECT_GE(found.values[k].dot(found.values[k - 1]), std::sin(0.5 * degree)) << method;
      EXPECT_LE(found.times[k] - found.times[k - 1], 20.5 / 30.0) << method << ": more than half a turn";
    }
  }
}

TEST(ReduceClips, ClosesWhatEndsAsItBegins) {
  RotationChannel loop{.joint = 0}, open = recorded_turns(1, 61, 0.0);
  for (int i = 0; i <= 60; ++i) {
    const double phase = i * 6.0 * degree;
    loop.times.push_back(i / 30.0);
    loop.values.push_back(exp<double>(Eigen::Vector3d(std::sin(phase), std::cos(phase), std::sin(2 * phase))));
  }
  loop.values.back() = Eigen::Quaterniond(-loop.values.front().coeffs());
  const ClipReduction found =
      reduced_arm({.name = "c", .rotations = {loop, open}}, {.tolerance = 0.2 * degree, .closed = true});
  EXPECT_EQ(found.open_tracks, 1u);
  const RotationChannel& closed = found.clip.rotations[0];
  const double sign = closed.values.front().dot(closed.values.back()) < 0.0 ? -1.0 : 1.0;
  EXPECT_EQ(closed.in_tangents.front().coeffs(), Eigen::Vector4d(sign * closed.in_tangents.back().coeffs()));
  EXPECT_EQ(Eigen::Vector4d(sign * closed.out_tangents.front().coeffs()), closed.out_tangents.back().coeffs());
  EXPECT_EQ(found.clip.rotations[1].out_tangents.back().coeffs(), Eigen::Vector4d::Zero());
  EXPECT_LE(farthest_at_keys(loop, closed), 0.2 * degree);
}

TEST(ReduceClips, SaysHowFarItIsBetweenTheKeys) {
  const Clip clip = swing(0.0);
  const ClipReduction found = reduced_arm(clip, {.tolerance = 0.5 * degree, .between = BetweenSamples::smooth});
  EXPECT_LE(found.from_smooth.largest.value, 0.5 * degree) << "of spans over several keys";
  EXPECT_GT(found.from_smooth.largest.value, 0.1 * degree);
  const ClipReduction stored = reduced_arm(clip, {.tolerance = 0.5 * degree, .between = BetweenSamples::stored});
  EXPECT_LE(stored.from_stored.largest.value, 0.5 * degree);
}

/// Of the rotations in the frames of the parents, and of the translations there, at many times.
void expect_held(const Clip& before, const Clip& after, double angle, double length) {
  for (std::size_t i = 0; i < before.rotations.size(); ++i) {
    const ChannelCurve<Eigen::Quaterniond> a(before.rotations[i]), b(after.rotations[i]);
    for (const double t : dense(before.rotations[i].times)) EXPECT_LE(apart(a.at(t), b.at(t)), angle) << i << ", " << t;
  }
  for (std::size_t i = 0; i < before.translations.size(); ++i) {
    const ChannelCurve<Eigen::Vector3d> a(before.translations[i]), b(after.translations[i]);
    for (const double t : dense(before.translations[i].times)) EXPECT_LE(apart(a.at(t), b.at(t)), length) << t;
  }
}

TEST(ReduceClips, HoldsTheTolerancesBetweenTheKeysByAnyMethod) {
  for (const double noise : {0.0, 0.02})
    for (const char* method : {"cubicspline", "hermite-c1", "slerp", "auto"}) {
      const Clip clip = swing(noise);
      const ClipReduction found =
          reduced_arm(clip, {.tolerance = 1.5 * degree, .position_tolerance = 0.01, .method = {method}});
      SCOPED_TRACE(method);
      expect_held(clip, found.clip, found.angle.largest.value * (1.0 + 1e-9), 0.01);
      EXPECT_LE(found.angle.largest.value, 1.5 * degree);
      EXPECT_LE(found.translation.largest.value, 0.01);
      EXPECT_LT(found.rotation_keys, noise == 0.0 ? found.rotation_keys_before / 2 : found.rotation_keys_before + 1);
    }
}

TEST(ReduceClips, HoldsTheToleranceWithinLargeSteps) {
  Clip clip{.name = "turns", .rotations = {{.joint = 0}}};
  RotationChannel& turns = clip.rotations[0];
  for (int i = 0; i < 24; ++i) {
    turns.times.push_back(0.1 * i);
    turns.values.push_back(exp<double>(Eigen::Vector3d(std::sin(1.0 * i), 0.0, std::cos(2.0 * i))) *
                           about_z(i % 3 == 2 ? 2.9 : 0.1 * i));
  }
  for (int i = 24; i < 200; ++i) {
    turns.times.push_back(0.1 * i);
    turns.values.push_back(turns.values[23] * about_z(1e-3 * (i - 23)));
  }
  const ClipReduction found = reduced_arm(clip, {.tolerance = 0.2 * degree});
  EXPECT_LT(found.rotation_keys, 100u);
  EXPECT_GT(found.rotation_keys, 24u) << "a cubic is not near a turn by 166° at a constant rate";
  expect_held(clip, found.clip, 0.2 * degree, 0.0);
}

/// At times so many times closer.
template <CurvePoint P>
Channel<P> hastened(Channel<P> channel, double factor) {
  for (double& time : channel.times) time /= factor;
  return channel;
}

// Values and times that a file holds may ask for tangents that it does not.
TEST(ReduceClips, KeepsKeysWhereTangentsWouldBeTooLargeForTheFile) {
  for (const auto& [precision, factor] : {std::pair(KeyPrecision::float32, 1e36), {KeyPrecision::float64, 1e308}}) {
    Clip clip = swing(0.0);
    clip.rotations[1] = hastened(hastened(clip.rotations[1], factor), 1e4);
    clip.translations[0] = hastened(clip.translations[0], 30.0);
    for (Eigen::Vector3d& value : clip.translations[0].values) value *= 1e38;
    const ClipReduction found = reduced_arm(
        clip, {.tolerance = degree, .position_tolerance = 1e36, .precision = precision, .precision_before = precision});
    EXPECT_TRUE(check_clip(arm(), found.clip));
    EXPECT_LT(found.clip.rotations[0].size(), clip.rotations[0].size());
    EXPECT_EQ(found.clip.rotations[1].values, clip.rotations[1].values);
    EXPECT_EQ(found.clip.translations[0].size() == clip.translations[0].size(), precision == KeyPrecision::float32);
  }
}

TEST(ReduceClips, NamesWhatIsWrong) {
  const Clip clip = swing();
  const auto fault = [&](const Clip& of, const ClipReduceOptions& options) {
    const auto found = reduce_clips(arm(), std::span(&of, 1), options, 1);
    return found ? "" : describe(found.error());
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault(clip, {.tolerance = 0.0}), "found a tolerance of 0, wanted one greater than 0");
  EXPECT_EQ(fault(clip, {.tolerance = nan}), "found a tolerance of nan, wanted one greater than 0");
  EXPECT_EQ(fault(clip, {.position_tolerance = -1.0}), "found a tolerance of -1, wanted one greater than 0");
  EXPECT_EQ(fault(clip, {.world_tolerance = 1.0, .shell = 0.0}), "found a tolerance of 0, wanted one greater than 0");
  EXPECT_NE(fault(clip, {.tolerance = 0.1, .method = {"bspline"}}).find("clip 'swing', joint"), std::string::npos);
  Clip torn = clip;
  torn.rotations[1].times[7] = torn.rotations[1].times[6];
  EXPECT_EQ(fault(torn, {.tolerance = 0.1}),
            "clip 'swing', joint 'elbow': key 7: found time 0.2 after 0.2, wanted increasing times");
}

}}  // namespace orispline
