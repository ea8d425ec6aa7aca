// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <reduce/recorded_walk.hpp>
#include <reduce/reduced_clip.hpp>

namespace orispline { namespace {

using testing_support::degree;
using testing_support::reduced_clip;

Skeleton one_joint() { return Skeleton::make({{.name = "hip"}}).value(); }

/// Twice around in two seconds, with the last key the first one again; `offset`: added to each turn.
RotationChannel loop(double offset, std::size_t intervals = 60) {
  RotationChannel channel{.joint = 0};
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(intervals), phase = 2 * std::numbers::pi * share;
    channel.times.push_back(2.0 * share);
    channel.values.push_back(
        exp<double>(Eigen::Vector3d(std::sin(phase + offset), std::cos(phase), std::sin(2 * phase))));
  }
  channel.values.back() = Eigen::Quaterniond(-channel.values.front().coeffs());
  return channel;
}

VectorChannel path() {
  VectorChannel channel{.joint = 0};
  for (int i = 0; i <= 60; ++i) {
    const double phase = i * 6.0 * degree;
    channel.times.push_back(i / 30.0);
    channel.values.emplace_back(std::sin(phase), 0.3 * std::sin(3 * phase), std::cos(phase));
  }
  channel.values.back() = channel.values.front();
  return channel;
}

ClipReduction reduced_joint(const Clip& clip, const ClipReduceOptions& options) {
  return reduced_clip(one_joint(), clip, options);
}

/// The body rate, or the velocity, just after the start and just before the end.
std::array<Eigen::Vector3d, 2> rates_at_ends(const RotationChannel& channel) {
  const auto rate = [](const Eigen::Quaterniond& q, const Eigen::Quaterniond& tangent) {
    return Eigen::Vector3d(2.0 * (q.conjugate() * tangent).vec());
  };
  return {rate(channel.values.front(), channel.out_tangents.front()),
          rate(channel.values.back(), channel.in_tangents.back())};
}
std::array<Eigen::Vector3d, 2> rates_at_ends(const VectorChannel& channel) {
  return {channel.out_tangents.front(), channel.in_tangents.back()};
}

template <CurvePoint P>
void expect_seamless(const Channel<P>& channel) {
  const auto [start, end] = rates_at_ends(channel);
  EXPECT_LT((start - end).norm(), 1e-6 * (1.0 + start.norm()));
  EXPECT_GT(start.norm(), 0.5) << "it moves there";
  double sign = 1.0;
  if constexpr (std::same_as<P, Eigen::Quaterniond>)
    sign = channel.values.front().dot(channel.values.back()) < 0 ? -1 : 1;
  const auto difference = [&](const P& a, const P& b) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>) return (a.coeffs() - sign * b.coeffs()).norm();
    else return (a - b).norm();
  };
  EXPECT_LT(difference(channel.in_tangents.front(), channel.in_tangents.back()), 1e-6);
  EXPECT_LT(difference(channel.out_tangents.front(), channel.out_tangents.back()), 1e-6);
}

TEST(ClosedClip, GoesOnWithoutAJumpOfItsRates) {
  for (const char* method : {"cubicspline", "hermite-c1"})
    for (const double tolerance : {0.05 * degree, 0.5 * degree, 4.0 * degree})
      for (const double offset : {0.0, 1.0, 2.5}) {
        const Clip clip{.name = "turn", .rotations = {loop(offset)}, .translations = {path()}};
        const ClipReduceOptions options{.tolerance = tolerance,
                                        .position_tolerance = 0.2 * tolerance,
                                        .method = {method},
                                        .between = BetweenSamples::smooth,
                                        .precision = KeyPrecision::float32,
                                        .closed = true};
        const ClipReduction found = reduced_joint(clip, options);
        SCOPED_TRACE(testing::Message() << method << ", " << tolerance << ", " << offset);
        expect_seamless(found.clip.rotations[0]);
        expect_seamless(found.clip.translations[0]);
        EXPECT_LE(found.angle.largest.value, tolerance);
        EXPECT_LE(found.from_smooth.largest.value, 1.5 * tolerance) << "nor does it swing at the seam";
        ClipReduceOptions open = options;
        open.closed = false;
        EXPECT_LE(found.rotation_keys, reduced_joint(clip, open).rotation_keys + 3);
      }
}

TEST(ClosedClip, OneSpanThatWouldHoldIsDivided) {
  RotationChannel nod{.joint = 0};  // forth and back, which one cubic is
  for (int i = 0; i <= 30; ++i) {
    const double u = i / 30.0;
    nod.times.push_back(u);
    nod.values.push_back(exp<double>(Eigen::Vector3d(u * (1.0 - u), 0.0, 0.0)));
  }
  const Clip clip{.name = "nod", .rotations = {nod}};
  EXPECT_EQ(reduced_joint(clip, {.tolerance = 0.5 * degree}).rotation_keys, 2u);
  const ClipReduction found = reduced_joint(clip, {.tolerance = 0.5 * degree, .closed = true});
  EXPECT_GT(found.rotation_keys, 2u);
  const auto [start, end] = rates_at_ends(found.clip.rotations[0]);
  EXPECT_LT((start - end).norm(), 1e-9);
  EXPECT_LE(found.angle.largest.value, 0.5 * degree);
}

TEST(ClosedClip, RatesThatJumpAreJoinedHalfWay) {
  RotationChannel saw{.joint = 0};  // leaves at 1 rad/s and comes back at -3 rad/s
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 10.0;
    saw.times.push_back(t);
    saw.values.push_back(exp<double>(Eigen::Vector3d(0.0, t <= 3.0 ? t : 3.0 * (4.0 - t), 0.0)));
  }
  const ClipReduction found =
      reduced_joint({.name = "saw", .rotations = {saw}}, {.tolerance = 0.2 * degree, .closed = true});
  const auto [start, end] = rates_at_ends(found.clip.rotations[0]);
  EXPECT_LT((start - end).norm(), 1e-9);
  EXPECT_NEAR(start.y(), -1.0, 0.5);
  EXPECT_LE(found.angle.largest.value, 0.2 * degree);
}

TEST(ClosedClip, EndsThatDifferByLessThanTheToleranceBecomeOne) {
  RotationChannel nearly = loop(0.0);
  nearly.values.back() = nearly.values.back() * exp<double>(Eigen::Vector3d(0.4 * degree, 0.0, 0.0));
  const Clip clip{.name = "walk", .rotations = {nearly}, .translations = {path()}};
  ClipReduceOptions options{.tolerance = 0.5 * degree, .between = BetweenSamples::smooth, .closed = true};
  const ClipReduction closed = reduced_joint(clip, options);
  expect_seamless(closed.clip.rotations[0]);
  EXPECT_LE(closed.angle.largest.value, 0.5 * degree);
  EXPECT_EQ(closed.open_tracks, 0u);
  EXPECT_TRUE(closed.open.empty());

  options.tolerance = 0.3 * degree;
  const ClipReduction open = reduced_joint(clip, options);
  EXPECT_EQ(open.open_tracks, 1u);
  ASSERT_EQ(open.open.size(), 1u);
  EXPECT_TRUE(open.open[0].is_rotation);
  EXPECT_NEAR(open.open[0].apart, 0.4 * degree, 1e-9);
}

/// A loop that is somewhere else for its second third, after a jump of 1 ms there and another one back.
template <CurvePoint P, class Elsewhere>
Channel<P> with_shots(const Channel<P>& channel, const Elsewhere& elsewhere) {
  Channel<P> shots{.joint = channel.joint};
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const auto put = [&](double t, bool is_there) {
      shots.times.push_back(t);
      shots.values.push_back(is_there ? elsewhere(channel.values[i]) : channel.values[i]);
    };
    const bool is_there = i >= 20 && i < 40;
    if (i == 20 || i == 40) put(channel.times[i] - 0.001, !is_there);
    put(channel.times[i], is_there);
  }
  return shots;
}

TEST(ClosedClip, TracksWithCutsAreClosedToo) {
  const Eigen::Quaterniond turn = exp<double>(Eigen::Vector3d(0.0, 2.0, 0.0));
  const Clip clip{
      .name = "shots",
      .rotations = {with_shots(loop(0.0), [&](const auto& q) { return turn * q; })},
      .translations = {with_shots(path(), [](const auto& p) { return Eigen::Vector3d(p.x() + 9.0, p.y(), p.z()); })}};
  for (const char* method : {"cubicspline", "hermite-c1"}) {
    SCOPED_TRACE(method);
    const ClipReduceOptions options{
        .tolerance = 0.5 * degree, .position_tolerance = 0.01, .method = {method}, .closed = true};
    const ClipReduction found = reduced_joint(clip, options);
    EXPECT_EQ(found.cuts, 2u);
    EXPECT_LT(found.rotation_keys, 40u);
    expect_seamless(found.clip.rotations[0]);
    expect_seamless(found.clip.translations[0]);
    EXPECT_LE(found.angle.largest.value, 0.5 * degree);
    EXPECT_LE(found.translation.largest.value, 0.01);
    EXPECT_EQ(found.open_tracks, 0u);
  }
}

TEST(ClosedClip, ATrackWithACutAtAnEndIsNamed) {
  RotationChannel jump = loop(0.0);
  jump.times.back() += 0.5;
  const Eigen::Quaterniond end = jump.values.back();
  jump.values.back() = exp<double>(Eigen::Vector3d(0.0, 2.0, 0.0)) * jump.values[59];
  jump.times.push_back(jump.times.back() + 0.001);
  jump.values.push_back(end);
  const ClipReduction found =
      reduced_joint({.name = "jump", .rotations = {jump}}, {.tolerance = 0.5 * degree, .closed = true});
  EXPECT_EQ(found.cuts, 1u);
  EXPECT_EQ(found.open_tracks, 1u);
  ASSERT_EQ(found.open.size(), 1u);
  EXPECT_TRUE(found.open[0].is_cut_at_ends);
}

TEST(ClosedClip, HermiteKeysAreSmoothInsideToo) {
  const Clip clip{.name = "turn", .rotations = {loop(0.0)}};
  const RotationChannel found =
      reduced_joint(clip, {.tolerance = 0.5 * degree, .method = {"hermite-c1"}}).clip.rotations[0];
  EXPECT_LT(found.size(), 30u);
  for (std::size_t k = 1; k + 1 < found.size(); ++k)
    EXPECT_LT((found.in_tangents[k].coeffs() - found.out_tangents[k].coeffs()).norm(), 1e-9) << "key " << k;
}

TEST(ClosedClip, OtherMethodsHaveNoTangentsToClose) {
  const Clip clip{.name = "turn", .rotations = {loop(0.0)}};
  const auto found =
      reduce_clips(one_joint(), std::span(&clip, 1), {.tolerance = 0.01, .method = {"slerp"}, .closed = true}, 1);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().message,
            "found the method slerp, wanted cubicspline, or hermite-c1 in its form chart: their tangents are free");
}

}}  // namespace orispline
