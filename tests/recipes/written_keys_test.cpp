// SPDX-License-Identifier: Apache-2.0
// Keys that a task made, written and read again: the file alone gives the curve that the task promised.
#include <gtest/gtest.h>

#include <orispline/analysis/distance.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/retime/retime.hpp>
#include <orispline/smooth/smooth.hpp>
#include <orispline/tune/tune.hpp>

#include "io/text_file.hpp"
#include "support/random_motion.hpp"

namespace orispline { namespace {

constexpr int samples = 401;

/// The curve of a file, by nothing but the file.
AnyCurve curve_in(const Track& track, const io::FormatInfo& format, int rate_orders) {
  const test::ScratchDirectory directory;
  const std::string path = directory.file("keys");
  auto file = io::OutputFile::open(path).value();
  EXPECT_TRUE(io::write_tracks(file, {&track, 1}, {.format = &format, .derivatives = rate_orders}));
  EXPECT_TRUE(file.finish());
  auto input = io::KeyInput::open(path).value();
  const Method method = method_of(input.recipe(), path).value().value();
  io::ReadOptions read{.format = &format, .rate_orders = rate_orders};
  for (const Parameter& parameter : (*find_family(method.name))->parameters)
    read.parameters.emplace_back(parameter.name);
  const Track again = io::read_track(std::move(input), read).value().track;
  return make_curve(completed(method, **find_family(method.name), again), again.keys).value();
}

void expect_same_bits(const AnyCurve& curve, const AnyCurve& again) {
  const auto [start, end] = curve.domain();
  ASSERT_EQ(again.domain().start, start);
  ASSERT_EQ(again.domain().end, end);
  for (int k = 0; k < samples; ++k) {
    const double t = start + (end - start) * k / (samples - 1);
    const Motion a = curve.motion(t), b = again.motion(t);
    ASSERT_EQ(a.orientation.coeffs(), b.orientation.coeffs()) << t;
    ASSERT_EQ(a.angular_velocity, b.angular_velocity) << t;
    ASSERT_EQ(a.angular_acceleration, b.angular_acceleration) << t;
    ASSERT_EQ(a.angular_jerk, b.angular_jerk) << t;
  }
}

template <class Result>
void expect_curve_of_file(const Result& result, int rate_orders = 0) {
  const AnyCurve curve = make_curve(result.method, result.track.keys).value();
  expect_same_bits(curve, curve_in(result.track, io::csv_format, rate_orders));
}

TEST(WrittenKeys, GiveTheTunedCurveBitForBit) {
  const Keyframes keys = random_keys(3, {12, 1.5, 20.0});
  for (const std::string_view text : {"timed-c2:ends=rest", "quintic", "nu", "tcb:bias=0.25", "timed-c3:ends=rest"}) {
    const Method method = method_from_text(text).value();
    const auto tuning = tune(keys, method, {});
    ASSERT_TRUE(tuning) << text << describe(tuning.error());
    expect_curve_of_file(*tuning);
  }
}

TEST(WrittenKeys, GiveTheRetimedCurveBitForBit) {
  const Keyframes keys = random_keys(5, {9, 1.5, 20.0});
  for (const std::string_view text : {"auto", "timed-c2:ends=rest", "timed-c3:tension=0.3:ends=natural", "slerp"}) {
    const auto slow = retime(keys, method_from_text(text).value(), {.limits = {.rate = 0.1}});
    ASSERT_TRUE(slow) << text << describe(slow.error());
    EXPECT_GT(slow->time_scale, 1.0);
    expect_curve_of_file(*slow);
  }
}

TEST(WrittenKeys, GiveTheSmoothedCurveBitForBit) {
  const auto smoothing = smooth(random_keys(7, {60, 0.3, 2.0}), {.smoothing_time = 0.5});
  ASSERT_TRUE(smoothing) << describe(smoothing.error());
  expect_curve_of_file(*smoothing, 2);
}

TEST(WrittenKeys, GiveTheReducedCurveWithinItsTolerance) {
  const double tolerance = 0.02;
  const AnyCurve motion = make_curve("auto", random_keys(11, {10, 0.8, 2.0})).value();
  KeyframeData data;
  for (int k = 0; k <= 600; ++k) {
    data.times.push_back(motion.domain().start + (motion.domain().end - motion.domain().start) * k / 600.0);
    data.orientations.push_back(motion.motion(data.times.back()).orientation);
  }
  const Track recording(Keyframes::make(data).value());
  for (const std::string_view method : reducing_methods) {
    const auto reduction = reduce(recording, method, {.tolerance = {.angle = tolerance}});
    ASSERT_TRUE(reduction) << describe(reduction.error());
    for (const io::FormatInfo* const format : {&io::csv_format, &io::tum_format}) {
      const AnyCurve curve = curve_in(reduction->track, *format, 0);
      const auto distance = distance_to_reference(curve, {recording.keys.times(), recording.keys.orientations()});
      EXPECT_LE(distance.largest, tolerance) << method;
      EXPECT_GT(distance.largest, 0.1 * tolerance) << method;
      EXPECT_EQ(distance.count, recording.keys.size());
    }
  }
}

TEST(WrittenKeys, KeepSignsThatMeanTurns) {
  KeyframeData data{.times = {0.0, 1.0, 2.0, 3.5}};
  for (const double angle : {0.0, 4.0, 9.0, 13.0})
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, angle)));
  Track track(Keyframes::make(data, Signs::as_given).value());
  track.recipe.signs = Signs::as_given;
  const auto slow = retime(track, "timed-c2", {.limits = {.rate = 0.5}});
  ASSERT_TRUE(slow) << describe(slow.error());
  expect_curve_of_file(*slow);
}

}}  // namespace orispline
