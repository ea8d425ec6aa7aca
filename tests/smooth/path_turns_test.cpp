// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/path_turns.hpp>

#include <gtest/gtest.h>

#include "smooth/gyro_case.hpp"

namespace orispline::gyro_motion { namespace {

namespace columns = calibration_columns;

GyroCalibration changed(GyroCalibration calibration, int column, double by) {
  CalibrationUnknowns change = CalibrationUnknowns::Zero();
  change[column] = by;
  calibration.correction += change.segment<3>(columns::correction);
  calibration.shape = shape_of(change) * calibration.shape;
  calibration.trend += change.segment<3>(columns::trend);
  calibration.offset += change[columns::offset];
  calibration.clock_rate += change[columns::clock_rate];
  return calibration;
}

TEST(PathTurns, MoveWithTheUnknownsAsTheirSlopesSay) {
  const GyroCase made(1, 4.0, 0.1);
  const GyroCalibration near{
      .correction = {0.02, -0.01, 0.03}, .trend = {0.01, 0.02, -0.01}, .offset = 0.02, .origin = 2.0};
  const SeenPoses poses = made.poses(degree);
  const auto turns = path_turns(poses, made.gyro, made.counts(), near);
  ASSERT_EQ(turns.size(), poses.times.size());
  for (int column = 0; column < columns::count; ++column) {
    constexpr double step = 1e-4;
    const auto more = path_turns(poses, made.gyro, made.counts(), changed(near, column, step)),
               less = path_turns(poses, made.gyro, made.counts(), changed(near, column, -step));
    const auto since_start = [](const auto& all, std::size_t k) { return Eigen::Vector3d(all[k].turn - all[0].turn); };
    double off = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const Eigen::Vector3d slope = turns[k].slopes.col(column) - turns[0].slopes.col(column);
      const Eigen::Vector3d moved = (since_start(more, k) - since_start(less, k)) / (2.0 * step);
      off = std::max(off, (slope + moved).norm());  // what the unknowns explain is taken off the turns
      largest = std::max(largest, slope.norm());
    }
    EXPECT_LT(off, 2e-2 * largest) << "column " << column;
  }
}

TEST(PathTurns, AreThoseOfTheCalibrationToFirstOrder) {
  GyroCase made(2, 4.0, 0.1);
  CalibrationUnknowns truth = CalibrationUnknowns::Zero();
  truth.head<9>() << 2e-3, -1e-3, 1e-3, 2e-3, -3e-3, 1e-3, 1e-3, 2e-3, -2e-3;
  truth.segment<3>(columns::trend) << 1e-3, -2e-3, 1e-3;
  made.set_off({.shape = shape_of(truth),
                .correction = truth.head<3>(),
                .trend = truth.segment<3>(columns::trend),
                .origin = 2.0});
  const auto turns = path_turns(made.poses(degree), made.gyro, made.counts(), {.origin = 2.0});
  double largest = 0.0, left = 0.0;
  for (const PathTurn& turn : turns) {
    largest = std::max(largest, (turn.turn - turns[0].turn).norm());
    left = std::max(left, (turn.turn - turns[0].turn - (turn.slopes - turns[0].slopes) * truth).norm());
  }
  EXPECT_GT(largest, 3e-3);
  EXPECT_LT(left, 0.03 * largest);
}

TEST(PathTurns, TurnWithTheWorld) {
  GyroCase made(3, 3.0, 0.1);
  made.add_noise(degree, 0.01);
  const GyroCalibration near{.correction = {0.02, -0.01, 0.03}};
  const auto before = path_turns(made.poses(degree), made.gyro, made.counts(), near);
  const Eigen::Quaterniond world = exp<double>(Eigen::Vector3d(0.3, -2.0, 1.0));
  const Eigen::Matrix3d turned = world.toRotationMatrix();
  for (Eigen::Quaterniond& q : made.data.orientations) q = world * q;
  const auto behind = path_turns(made.poses(degree), made.gyro, made.counts(), near);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_LT((behind[k].turn - turned * before[k].turn).norm(), 1e-12);
    EXPECT_LT((behind[k].walked - turned * before[k].walked).norm(), 1e-12);
    EXPECT_LT((behind[k].to_world - turned * before[k].to_world).norm(), 1e-12);
    EXPECT_LT((behind[k].slopes - turned * before[k].slopes).norm(), 1e-10);
  }
}

}}  // namespace orispline::gyro_motion
