// SPDX-License-Identifier: Apache-2.0
// What options are that nobody states, and results of which nothing was found. The pages have the former in their
// tables.
#include <gtest/gtest.h>

#include <orispline/align.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/io/sample_columns.hpp>
#include <orispline/mean.hpp>
#include <orispline/reduce/key_search.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/retime.hpp>
#include <orispline/smooth.hpp>

namespace orispline { namespace {

/// A number of an object that was made without any.
struct Default {
  std::string_view name;
  double found, wanted;
};

void expect(const std::vector<Default>& defaults) {
  for (const Default& value : defaults) EXPECT_EQ(value.found, value.wanted) << value.name;
}

TEST(Defaults, OfOptionsAreThoseThatPagesState) {
  const io::SampleColumns columns;
  expect({{"keep_every", static_cast<double>(Decimation{}.keep_every), 8.0},
          {"seed", static_cast<double>(Decimation{}.seed), 1.0},
          {"derivatives", static_cast<double>(columns.derivatives), 0.0},
          {"position_derivatives", static_cast<double>(columns.position_derivatives), 0.0},
          {"keys_moved", static_cast<double>(Repair{}.keys_moved), 0.0},
          {"insert_keys", static_cast<double>(RetimeOptions{}.insert_keys), 0.0}});
  EXPECT_EQ(Decimation{}.spacing, Spacing::even);
  EXPECT_FALSE(columns.positions || columns.band);
  EXPECT_EQ(columns.frame, io::Frame::body);
  EXPECT_EQ(columns.turning, io::Turning::body_to_world);
  EXPECT_EQ(MeanOptions{}.kind, MeanKind::mean);
  const SmoothOptions smooth;
  EXPECT_EQ(smooth.loss, Loss::robust);
  EXPECT_FALSE(smooth.gyro_bias || smooth.noise_time);
  EXPECT_TRUE(smooth.adapt);
  EXPECT_FALSE(smooth.gyro || smooth.sigma);
  EXPECT_EQ(RetimeOptions{}.slowing, Slowing::uniform);
}

TEST(Defaults, OfResultsAreNothing) {
  const Mean mean;
  const RateAlignment rates;
  const Deviation deviation;
  const PositionSmoothing positions;
  expect({{"Mean::ball_radius", mean.ball_radius, 0.0},
          {"Mean::residual", mean.residual, 0.0},
          {"Mean::iterations", static_cast<double>(mean.iterations), 0.0},
          {"Mean::rms_distance", mean.rms_distance, 0.0},
          {"Mean::largest_distance", mean.largest_distance, 0.0},
          {"Mean::farthest", static_cast<double>(mean.farthest), 0.0},
          {"MeanWindow::time", MeanWindow{}.time, 0.0},
          {"MeanWindow::first", static_cast<double>(MeanWindow{}.first), 0.0},
          {"OpenRateDirection::offset", OpenRateDirection{}.offset, 0.0},
          {"RateAlignment::offset_sigma", rates.offset_sigma, 0.0},
          {"RateAlignment::compared", static_cast<double>(rates.compared), 0.0},
          {"RateAlignment::excess", rates.excess, 0.0},
          {"Deviation::angle", deviation.angle, 0.0},
          {"Deviation::angle_at", static_cast<double>(deviation.angle_at), 0.0},
          {"Deviation::position_at", static_cast<double>(deviation.position_at), 0.0},
          {"PositionSmoothing::chosen_on", static_cast<double>(positions.chosen_on), 0.0},
          {"PositionSmoothing::noise", positions.noise, 0.0},
          {"PositionSmoothing::local_noise", positions.local_noise, 0.0},
          {"LambdaChoice::lambda", LambdaChoice{}.lambda, 0.0},
          {"SampleDistances::rms", SampleDistances{}.rms, 0.0},
          {"SampleDistances::largest", SampleDistances{}.largest, 0.0}});
  EXPECT_EQ(mean.orientation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_EQ(rates.body.coeffs(), Eigen::Quaterniond::Identity().coeffs());
  for (const Eigen::Vector3d& v :
       {rates.bias, rates.body_sigma, rates.bias_sigma, OpenRateDirection{}.body, SmoothedNodes{}.gyro_correction})
    EXPECT_TRUE(v.isZero(0.0));
  EXPECT_FALSE(deviation.position);
  EXPECT_EQ(positions.edge, LambdaChoice::Edge::none);
}

}}  // namespace orispline
