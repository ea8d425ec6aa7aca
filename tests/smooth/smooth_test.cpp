// SPDX-License-Identifier: Apache-2.0
// What smoothing a recording promises: the truth comes nearer, outliers and faults of a gyro are found, and refusals.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/base/formatted.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>
#include <support/follower.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline { namespace {

TEST(Smooth, ComesNearTheTruthWithoutBeingToldAnything) {
  const auto recording = recorded(1500, degree);
  const auto smoothing = smooth(Keyframes::make(recording.noisy).value()).value();
  EXPECT_EQ(smoothing.criterion, SmoothingCriterion::gcv);
  EXPECT_NEAR(smoothing.noise / degree, 1.0, 0.05);
  EXPECT_NEAR(smoothing.local_noise / degree, 1.0, 0.08);
  EXPECT_TRUE(smoothing.rejected.empty());
  EXPECT_LT(smoothing.last_step, 1e-9);
  const double found = rms(smoothing, recording.clean);
  EXPECT_LT(found, 0.45 * degree);
  for (const double factor : {0.5, 2.0}) {  // the choice is near the best one
    const SmoothOptions other{.smoothing_time = factor * smoothing.smoothing_time};
    EXPECT_GT(rms(smooth(Keyframes::make(recording.noisy).value(), other).value(), recording.clean), 0.95 * found);
  }
}

TEST(Smooth, FindsEveryOutlierAndNoOther) {
  auto recording = recorded(1500, degree);
  std::vector<std::size_t> faults;
  for (std::size_t i = 20; i < 1500; i += 73) {
    faults.push_back(i);
    recording.noisy.orientations[i] = recording.noisy.orientations[i] * exp<double>(Eigen::Vector3d(0.0, 0.35, 0.0));
  }
  const auto smoothing = smooth(Keyframes::make(recording.noisy).value()).value();
  EXPECT_EQ(smoothing.rejected, faults);
  EXPECT_LT(smoothing.last_step, 1e-9);
  const auto trusting = smooth(Keyframes::make(recording.noisy).value(), {.loss = Loss::l2}).value();
  EXPECT_LT(rms(smoothing, recording.clean), 0.7 * rms(trusting, recording.clean));
}

TEST(Smooth, CountsSamplesWithLittleWeightAsFewerObservations) {
  auto recording = recorded(300, degree);
  for (std::size_t i = 20; i < 300; i += 31)
    recording.noisy.orientations[i] = recording.noisy.orientations[i] * exp<double>(Eigen::Vector3d(0.0, 0.35, 0.0));
  const Keyframes keys = Keyframes::make(recording.noisy).value();
  const auto freedom = [&](Loss loss) {
    return *smooth(keys, {.smoothing_time = 0.05, .loss = loss}).value().degrees_of_freedom;
  };
  EXPECT_LT(freedom(Loss::huber), 0.99 * freedom(Loss::l2));
}

// A jerk that is penalised much keeps far more turns than one from where the search begins; less and less smoothing
// leads there in five steps instead of thirteen.
TEST(Smooth, FindsItsWayToStronglySmoothedSpins) {
  KeyframeData data;
  Dice dice(11);
  for (int i = 0; i < 1500; ++i) {
    data.times.push_back(0.01 * i);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, std::remainder(0.5 * i, 6.283185307179586))) *
                                exp<double>(Eigen::Vector3d(0.02 * normal_vector(dice))));
  }
  const auto smoothing =
      smooth(Keyframes::make(data).value(), {.penalty = Penalty::jerk, .smoothing_time = 0.5, .loss = Loss::l2});
  ASSERT_TRUE(smoothing) << describe(smoothing.error());
  EXPECT_LE(smoothing->iterations, 8);
}

// The jerk of this motion is 0: what is penalised vanishes, and the motion comes out whatever its noise is.
TEST(Smooth, GivesTheRatesOfTheKeys) {
  KeyframeData data;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.01 * i;
    data.times.push_back(t);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.3 * t + t * t, 0.0)));
  }
  const Keyframes recording = Keyframes::make(std::move(data)).value();
  for (const Loss loss : {Loss::l2, Loss::robust}) {
    const Keyframes keys =
        smooth(recording, {.penalty = Penalty::jerk, .smoothing_time = 0.1, .loss = loss}).value().track.keys;
    ASSERT_EQ(keys.angular_accelerations().size(), 200u);
    for (std::size_t i = 0; i < 200; ++i) {
      EXPECT_LT((keys.angular_velocities()[i] - Eigen::Vector3d(0.0, 0.3 + 0.02 * static_cast<double>(i), 0.0)).norm(),
                1e-7);
      EXPECT_LT((keys.angular_accelerations()[i] - Eigen::Vector3d(0.0, 2.0, 0.0)).norm(), 1e-5);
    }
  }
}

TEST(Smooth, StretchesDoNotKnowEachOther) {
  const auto recording = recorded(300, degree);
  KeyframeData cut = recording.noisy, first = recording.noisy;
  for (std::size_t i = 150; i < 300; ++i) cut.times[i] += 5.0;
  cut.times[299] += 5.0;  // stands alone
  first.times.resize(150);
  first.orientations.resize(150);
  const SmoothOptions options{.smoothing_time = 0.05, .gap = 1.0};
  const auto whole = smooth(Keyframes::make(cut).value(), options).value();
  const auto part = smooth(Keyframes::make(first).value(), options).value();
  ASSERT_EQ(whole.stretches.size(), 2u);
  EXPECT_EQ(whole.samples_in_short_stretches, std::vector<std::size_t>{299});
  ASSERT_EQ(whole.nodes.orientations.size(), 299u);
  const SmoothOptions plain{.smoothing_time = 0.05, .loss = Loss::l2, .gap = 1.0};
  const auto a = smooth(Keyframes::make(cut).value(), plain).value();
  const auto b = smooth(Keyframes::make(first).value(), plain).value();
  for (std::size_t i = 0; i < 150; ++i)
    EXPECT_LT(angular_distance(a.nodes.orientations[i], b.nodes.orientations[i]), 1e-8);
}

TEST(Smooth, GyroBringsTheMotionNearerAndItsBiasIsFound) {
  auto recording = recorded(1000, degree);
  const auto plain = smooth(Keyframes::make(recording.noisy).value()).value();
  const Eigen::Vector3d bias(0.02, -0.01, 0.03);
  Dice dice(11);
  for (const double t : recording.clean.times) {
    const Eigen::Quaterniond second = exp<double>(Eigen::Vector3d(std::sin(3.0 * t), 0.0, 0.0));
    const Eigen::Vector3d rate = to_body<double>(second, Eigen::Vector3d(0.0, 0.0, 2.0 * std::cos(2.0 * t))) +
                                 Eigen::Vector3d(3.0 * std::cos(3.0 * t), 0.0, 0.0);
    recording.noisy.angular_velocities.push_back(rate + bias + 0.01 * normal_vector(dice));
  }
  const auto fused = smooth(Keyframes::make(recording.noisy).value(), {.gyro = true}).value();
  EXPECT_EQ(fused.criterion, SmoothingCriterion::reml);
  EXPECT_NEAR(fused.gyro->noise, 0.01, 0.001);
  EXPECT_LT((fused.nodes.gyro_correction + bias).norm(), 0.003);
  EXPECT_LT(rms(fused, recording.clean), 0.6 * rms(plain, recording.clean));
}

void expect_refusal(const KeyframeData& data, const SmoothOptions& options, ErrorCode code, const char* message) {
  const auto refused = smooth(Keyframes::make(data).value(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code);
  EXPECT_EQ(describe(refused.error()), message);
}

TEST(Smooth, FollowsARotationOfManyDegreesPerSample) {
  for (const double step : {20.0, 45.0, 90.0, 150.0}) {
    SCOPED_TRACE(step);
    KeyframeData spin, noisy;
    Dice dice(11);
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.0, std::remainder(step * i, 360.0) * degree, 0.0));
      spin.orientations.push_back(q);
      noisy.orientations.push_back(q * exp<double>(Eigen::Vector3d(degree * normal_vector(dice))));
      noisy.times.push_back(0.01 * i);
    }
    const auto smoothing = smooth(Keyframes::make(noisy).value()).value();
    EXPECT_LT(rms(smoothing, spin), 0.2 * degree);
    EXPECT_NEAR(smoothing.local_noise / degree, 1.0, 0.3);
    EXPECT_NEAR(smoothing.nodes.angular_velocities[500].norm(), step * degree / 0.01, 0.01 * step * degree / 0.01);
  }
}

TEST(Smooth, DoesNotTakeTheMotionBetweenLongRestsForOutliers) {
  KeyframeData data;  // 6 s of rest, 2 s of motion, 6 s of rest, without noise
  for (int i = 0; i < 1400; ++i) {
    const double t = std::clamp(0.01 * i - 6.0, 0.0, 2.0);
    data.times.push_back(0.01 * i);
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, 0.5 * (1.0 - std::cos(1.5707963267948966 * t)))));
  }
  const auto smoothing = smooth(Keyframes::make(data).value()).value();
  EXPECT_LT(rms(smoothing, data), 0.01 * degree);
}

TEST(Smooth, TellsAGyroThatDoesNotMeasureTheMotion) {
  const auto recording = recorded(1000, degree);
  auto data = recording.noisy;
  std::vector<Eigen::Vector3d> rates;  // of the clean motion
  for (const double t : data.times) {
    const Eigen::Quaterniond second = exp<double>(Eigen::Vector3d(std::sin(3.0 * t), 0.0, 0.0));
    rates.emplace_back(to_body(second, Eigen::Vector3d(0.0, 0.0, 2.0 * std::cos(2.0 * t))) +
                       Eigen::Vector3d(3.0 * std::cos(3.0 * t), 0.0, 0.0));
  }
  data.angular_velocities = rates;
  data.angular_velocities[300] = Eigen::Vector3d(0.0, 300.0, 0.0);
  const auto fused = smooth(Keyframes::make(data).value(), {.gyro = true}).value();
  EXPECT_EQ(fused.gyro->rejected, std::vector<std::size_t>{300});
  EXPECT_LT(rms(fused, recording.clean), 0.5 * degree);
  const auto expect_refused = [&](const auto& made, const char* beginning, const char* cure) {
    for (std::size_t i = 0; i < rates.size(); ++i)
      data.angular_velocities[i] = made(recording.clean.orientations[i], rates[i]);
    const auto refused = smooth(Keyframes::make(data).value(), {.gyro = true});
    ASSERT_FALSE(refused) << beginning;
    EXPECT_TRUE(refused.error().message.starts_with(beginning)) << refused.error().message;
    EXPECT_NE(refused.error().message.find(cure), std::string::npos) << refused.error().message;
  };
  using Vector = Eigen::Vector3d;
  using Turn = Eigen::Quaterniond;
  const char* const contradicts = "the gyro's rates contradict the orientations: they vary by";
  const char* const world = "`columns` wx_world=…,wy_world=…,wz_world=…";
  const char* const conjugate = "the orientations turn the other way round: give `conjugate`";
  expect_refused([](const Turn&, const Vector& w) { return Vector(w / degree); }, contradicts, "end in _deg_s");
  expect_refused([](const Turn&, const Vector& w) { return Vector(-w); }, contradicts, "all signs reversed");
  expect_refused([](const Turn& q, const Vector& w) { return Vector(q * w); }, contradicts, world);
  expect_refused([](const Turn& q, const Vector& w) { return Vector(-(q * w)); }, contradicts, conjugate);
  Vector sum = Vector::Zero();
  double squares = 0.0;
  for (const Vector& w : rates) {
    sum += w;
    squares += w.squaredNorm();
  }
  const auto count = static_cast<double>(rates.size());
  const double spread = 100.0 * std::sqrt(squares / count - (sum / count).squaredNorm());
  expect_refused([](const Turn&, const Vector& w) { return Vector(100.0 * w + Vector(500.0, 0.0, 0.0)); },
                 formatted("the gyro's rates vary by {:.3g} rad/s, ", spread).c_str(), "wanted a gyro in rad/s");
  expect_refused([](const Turn&, const Vector& w) { return Vector(-w.x(), -w.z(), -w.y()); }, contradicts,
                 "they agree if x, y and z of the rates are -x, -z, -y of the body");
  // Mounted askew by 50° and reversed: no word of ours mends that.
  const Eigen::AngleAxisd askew(50.0 * degree, Vector(1.0, 1.0, 1.0).normalized());
  expect_refused([&](const Turn&, const Vector& w) { return Vector(-(askew * w)); },
                 "the gyro turns against the orientations: their rates vary by",
                 "wanted rates of the body in its own frame");
}

TEST(Smooth, SaysWhatItCannotDo) {
  const auto data = recorded(100, degree).noisy;
  const KeyframeData two{.times = {0.0, 1.0}, .orientations = {2, Eigen::Quaterniond::Identity()}};
  expect_refusal(two, {}, ErrorCode::bad_data, "found 2 samples, wanted at least 3 to smooth");
  expect_refusal(data, {.noise = 0.0}, ErrorCode::bad_argument, "noise: found 0 rad, wanted 1e-07 to 0.5 rad");
  expect_refusal(data, {.smoothing_time = 1e300}, ErrorCode::bad_argument,
                 "smoothing_time: found 1e+300 s, wanted 1e-05 to 9.9 s");
  expect_refusal(data, {.gyro = true, .gyro_noise = 1e-300}, ErrorCode::bad_argument,
                 "gyro_noise: found 1e-300 rad/s, wanted 1e-09 to 1000 rad/s");
  expect_refusal(data, {.noise = 0.1, .smoothing_time = 1.0}, ErrorCode::bad_argument,
                 "noise: wanted no `smoothing_time` as well: each determines how smooth");
  expect_refusal(data, {.gap = 0.01}, ErrorCode::bad_argument,
                 "gap: found 0.01 s, wanted more than the median interval of 0.01 s");
  expect_refusal(data, {.gyro = true}, ErrorCode::bad_data,
                 "found no angular velocities of the body, wanted wx,wy,wz of the gyro");
  expect_refusal(
      data, {.noise = 1e-6}, ErrorCode::bad_data,
      "100 of 100 samples are farther than 5 σ from the best motion, σ = 5.73e-05°, wanted a larger noise, a "
      "shorter smoothing time, or the loss l2, which has no outliers");
  KeyframeData wild = data;
  Dice dice(5);
  for (Eigen::Quaterniond& q : wild.orientations) q = exp<double>(Eigen::Vector3d(3.0 * dice.vector()));
  const auto refused = smooth(Keyframes::make(wild).value());
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().message.starts_with("no smooth motion is near to the samples"))
      << refused.error().message;
}

TEST(Smooth, RefusesWhatDoesNotEndWithoutLookingFurther) {
  const Keyframes keys =
      Keyframes::make(testing_support::random_walk(7, 180, testing_support::Spacing::uneven)).value();
  const auto steps_to_refusal = [&](bool adapt) {
    int steps = 0;
    const auto refused = smooth(keys, {.penalty = Penalty::jerk, .noise = 3e-5, .loss = Loss::tukey, .adapt = adapt},
                                Progress{.stop = {}, .show = [&steps](double) { ++steps; }});
    EXPECT_EQ(refused.error().code, ErrorCode::not_converged);
    return steps;
  };
  EXPECT_EQ(steps_to_refusal(true), steps_to_refusal(false));
}

TEST(Smooth, IsFollowedAndStopped) {
  const auto recording = recorded(400, degree);
  const Keyframes keys = Keyframes::make(recording.noisy).value();
  for (const Penalty penalty : {Penalty::acceleration, Penalty::jerk})
    for (const Loss loss : {Loss::robust, Loss::tukey})
      testing_support::expect_to_be_followed_and_stopped(
          [&](const Progress& progress) { return smooth(keys, {.penalty = penalty, .loss = loss}, progress); }, 3);
}

}}  // namespace orispline
