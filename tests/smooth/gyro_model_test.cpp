// SPDX-License-Identifier: Apache-2.0
// What the model says of gyros of which everything is known.
#include <orispline/smooth/gyro_model.hpp>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "smooth/gyro_case.hpp"

namespace orispline::gyro_motion { namespace {

namespace columns = calibration_columns;

constexpr double pose_noise = 0.5 * degree, rate_noise = 0.3 * degree;  // of an orientation [rad], of a rate [rad/s]
constexpr double interval = 0.01;                                       // of the rates [s]

GyroModel model_of(const GyroCase& made, const GyroAlignment& near = {}) {
  return gyro_model(made.poses(pose_noise), made.gyro, made.counts(),
                    {.near = {.correction = near.correction, .offset = near.offset},
                     .rate_noise = rate_noise * std::sqrt(interval),
                     .pose_noise = pose_noise,
                     .finds_offset = true,
                     .finds_clock_rate = true,
                     .finds_trend = true});
}

void expect_within(const GyroModel& model, const CalibrationUnknowns& truth, int first, int count) {
  for (int k = first; k < first + count; ++k)
    EXPECT_LE(std::abs(model.values[k] - truth[k]), 4.0 * model.sigmas[k]) << "column " << k;
}

TEST(GyroModel, FindsScaleMountAndClock) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    GyroCase made(seed);
    CalibrationUnknowns truth = CalibrationUnknowns::Zero();
    truth.segment<3>(columns::correction) << 0.01, -0.02, 0.005;
    truth.segment<3>(columns::scale) << 0.02, -0.01, 0.005;
    truth.segment<3>(columns::mount) << 0.02, 0.0, -0.03;
    truth[columns::offset] = 0.012;
    truth[columns::clock_rate] = 4e-4;
    made.set_off({.shape = shape_of(truth),
                  .correction = truth.head<3>(),
                  .offset = truth[columns::offset],
                  .clock_rate = truth[columns::clock_rate],
                  .origin = std::midpoint(made.data.times.front(), made.data.times.back())});
    made.add_noise(pose_noise, rate_noise);
    const GyroModel model = model_of(made);
    EXPECT_TRUE(model.has_scale && model.has_mount && model.has_clock_rate) << seed;
    expect_within(model, truth, 0, columns::count);
    EXPECT_EQ(model.noises.drift, 0.0) << seed;
    EXPECT_EQ(model.noises.correlated, 0.0) << seed;
  }
}

/// A clock that began long before, as of a sensor that counts since it was switched on.
TEST(GyroModel, FindsThePaceOfAClockThatIsFarOff) {
  GyroCase made(7);
  const double far = 86400.0;
  made.set_off({.offset = far,
                .clock_rate = 4e-4,
                .origin = far + std::midpoint(made.data.times.front(), made.data.times.back())});
  made.add_noise(pose_noise, rate_noise);
  const GyroModel model = model_of(made, {.offset = far});
  EXPECT_TRUE(model.has_clock_rate);
  EXPECT_LE(std::abs(model.calibration.clock_rate - 4e-4), 4.0 * model.sigmas[columns::clock_rate]);
  EXPECT_NEAR(model.calibration.offset, far, 2e-3);
}

TEST(GyroModel, TellsNothingOfWhatIsNotThere) {
  for (std::uint64_t seed = 10; seed < 12; ++seed) {
    GyroCase made(seed);
    made.add_noise(pose_noise, rate_noise);
    const GyroModel model = model_of(made);
    EXPECT_FALSE(model.has_scale || model.has_mount || model.has_trend || model.has_clock_rate) << seed;
    EXPECT_EQ(model.calibration.trend, Eigen::Vector3d(0.0, 0.0, 0.0)) << seed;
    const auto shape = model.values.segment<6>(columns::scale), sigmas = model.sigmas.segment<6>(columns::scale);
    EXPECT_LT(shape.cwiseAbs().maxCoeff(), 1e-4) << seed;  // a tenth of what least squares would find
    EXPECT_GT(sigmas.minCoeff(), 0.0) << seed;             // though it may be there
    EXPECT_EQ(model.noises.drift, 0.0) << seed;
    EXPECT_EQ(model.noises.clock, 0.0) << seed;
    EXPECT_EQ(model.noises.correlated, 0.0) << seed;
    EXPECT_NEAR(model.noises.white, pose_noise, 0.1 * pose_noise) << seed;
    expect_within(model, CalibrationUnknowns::Zero(), 0, columns::count);
  }
}

/// Of a vehicle, whose orientations and rates are about one axis alone.
TEST(GyroModel, TakesNoNoiseInAPlaneForThatOfTheClock) {
  GyroCase made(23);
  const auto heading = [](double t) { return std::sin(0.9 * t) + 0.5 * std::sin(2.3 * t); };
  for (std::size_t k = 0; k < made.data.times.size(); ++k)
    made.data.orientations[k] = exp<double>(Eigen::Vector3d(
        (heading(made.data.times[k]) + pose_noise * normal_vector(made.dice).z()) * Eigen::Vector3d::UnitZ()));
  for (std::size_t k = 0; k < made.gyro.times.size(); ++k) {
    const double t = made.gyro.times[k], turning = 0.9 * std::cos(0.9 * t) + 1.15 * std::cos(2.3 * t);
    made.gyro.rates[k] = (turning + rate_noise * normal_vector(made.dice).z()) * Eigen::Vector3d::UnitZ();
  }
  EXPECT_EQ(model_of(made).noises.clock, 0.0);
}

TEST(GyroModel, FindsATrendOfTheBias) {
  GyroCase made(22);
  CalibrationUnknowns truth = CalibrationUnknowns::Zero();
  truth.head<3>() << 0.01, -0.02, 0.005;
  truth.segment<3>(columns::trend) << -0.25 * degree, 0.15 * degree, -0.1 * degree;
  made.set_off({.correction = truth.head<3>(),
                .trend = truth.segment<3>(columns::trend),
                .origin = std::midpoint(made.data.times.front(), made.data.times.back())});
  made.add_noise(pose_noise, rate_noise);
  const GyroModel model = model_of(made);
  EXPECT_TRUE(model.has_trend);
  expect_within(model, truth, 0, columns::count);
  EXPECT_LT(model.sigmas.segment<3>(columns::trend).maxCoeff(), 0.03 * degree);
  EXPECT_LT(model.noises.drift, 0.02 * degree);  // a walk that is taken for it would be ten times as large
}

TEST(GyroModel, FindsADriftOfTheBias) {
  GyroCase made(20);
  const double drift = 0.5 * degree;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  for (Eigen::Vector3d& rate : made.gyro.rates) rate += bias += drift * std::sqrt(interval) * normal_vector(made.dice);
  made.add_noise(pose_noise, rate_noise);
  const GyroModel model = model_of(made);
  EXPECT_FALSE(model.has_trend);
  EXPECT_NEAR(std::log(model.noises.drift / drift), 0.0, std::log(2.0));
  EXPECT_EQ(model.noises.correlated, 0.0);
}

/// A first-order Markov process, in the frame of the body.
void add_correlated(GyroCase& made, double sigma, double time) {
  const double keeps = std::exp(-(made.data.times[1] - made.data.times[0]) / time);
  Eigen::Vector3d noise = sigma * normal_vector(made.dice);
  for (Eigen::Quaterniond& q : made.data.orientations) {
    q = q * exp<double>(noise);
    noise = keeps * noise + sigma * std::sqrt(1.0 - keeps * keeps) * normal_vector(made.dice);
  }
}

TEST(GyroModel, FindsNoiseThatCorrelates) {
  GyroCase made(21, 40.0);
  const double time = 0.4, sigma = 1.5 * degree;
  add_correlated(made, sigma, time);
  made.add_noise(pose_noise, rate_noise);
  const GyroModel model = model_of(made);
  EXPECT_NEAR(std::log(model.noises.correlated / sigma), 0.0, std::log(1.4));
  EXPECT_NEAR(std::log(model.noises.correlation_time / time), 0.0, std::log(2.0));
  EXPECT_NEAR(model.noises.white, pose_noise, 0.2 * pose_noise);
}

// Of which the recording holds a few times only: it is neither taken for noise of the rates nor for one that is
// forgotten sooner.
TEST(GyroModel, FindsNoiseThatCorrelatesForLong) {
  const double time = 5.0, sigma = degree;
  for (const std::uint64_t seed : {33u, 38u}) {
    GyroCase made(seed, 20.0, 0.01);
    add_correlated(made, sigma, time);
    made.add_noise(0.0, rate_noise);
    const GyroModel model = model_of(made);
    EXPECT_NEAR(std::log(model.noises.correlated / sigma), 0.0, std::log(2.0)) << seed;
    EXPECT_NEAR(std::log(model.noises.correlation_time / time), 0.0, std::log(3.0)) << seed;
    EXPECT_LT(model.noises.rate, 1.5 * rate_noise * std::sqrt(interval)) << seed;
  }
}

}}  // namespace orispline::gyro_motion
