// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_columns.hpp>

#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_writer.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::ScratchDirectory;
using test::text_of;
using test::TextFile;
using testing_support::near;

constexpr double pi = std::numbers::pi;

Expected<KeyFile> oriented_file(const std::string& content, const OrientationReading& orientation = {},
                                const ColumnNames& columns = {}) {
  return read_keys(TextFile(content).path(), {.columns = columns, .orientation = orientation});
}

Eigen::Quaterniond orientation_in(const std::string& content, const OrientationReading& reading = {},
                                  const ColumnNames& columns = {}) {
  const auto file = oriented_file(content, reading, columns);
  if (file) return file->data.orientations[0];
  ADD_FAILURE() << describe(file.error());
  return Eigen::Quaterniond::Identity();
}

std::string orientation_refusal(const std::string& content, const OrientationReading& reading = {},
                                ErrorCode code = ErrorCode::bad_data) {
  const auto file = oriented_file(content, reading);
  if (file) return "read without an error";
  EXPECT_EQ(file.error().code, code);
  return text_of(file.error());
}

Eigen::Quaterniond about(const Eigen::Vector3d& axis, double angle) { return exp<double>(angle * axis); }
const Eigen::Vector3d along_x = Eigen::Vector3d::UnitX(), along_y = Eigen::Vector3d::UnitY(),
                      along_z = Eigen::Vector3d::UnitZ();

/// Yaw, then pitch, then roll, each about the axis as it has come to stand.
const Eigen::Quaterniond three_turns = about(along_z, 0.5) * about(along_y, -0.25) * about(along_x, 2.0);

TEST(RollPitchYaw, AreTurnsAboutTheBodysZThenYThenX) {
  EXPECT_TRUE(near(orientation_in("t,roll_rad,pitch_rad,yaw_rad\n0,2,-0.25,0.5\n"), three_turns, tolerance::exact));
  const std::string degrees = fmt::format("0,{},{},{}\n", 360 / pi, -45 / pi, 90 / pi);
  EXPECT_TRUE(near(orientation_in("t,roll_deg,pitch_deg,yaw_deg\n" + degrees), three_turns, tolerance::exact));
  EXPECT_TRUE(near(orientation_in("t,yaw_deg,pitch_rad,roll_rad\n" + fmt::format("0,{},-0.25,2\n", 90 / pi)),
                   three_turns, tolerance::exact));
}

TEST(RollPitchYaw, WithoutAUnitNeedOneFromTheCaller) {
  const std::string plain = "t,roll,pitch,yaw\n0,2,-0.25,0.5\n";
  EXPECT_TRUE(near(orientation_in(plain, {.angle_unit = AngleUnit::radians}), three_turns, tolerance::exact));
  EXPECT_TRUE(near(orientation_in("t,roll,pitch,yaw\n" + fmt::format("0,{},{},{}\n", 360 / pi, -45 / pi, 90 / pi),
                                  {.angle_unit = AngleUnit::degrees}),
                   three_turns, tolerance::exact));
  EXPECT_EQ(orientation_refusal(plain),
            "keys.csv:1: 'yaw' has no unit, wanted a name such as yaw_deg or yaw_rad, or the unit (option angle_unit)");
  EXPECT_TRUE(near(orientation_in("t,roll_rad,pitch,yaw_rad\n0,2,-0.25,0.5\n", {.angle_unit = AngleUnit::radians}),
                   three_turns, tolerance::exact));
}

TEST(RollPitchYaw, FollowTheOrderThatTheCallerStates) {
  const std::string plain = "t,roll_rad,pitch_rad,yaw_rad\n0,2,-0.25,0.5\n";
  EXPECT_TRUE(near(orientation_in(plain, {.euler = euler_order_of("XYZ")}),
                   about(along_x, 2.0) * about(along_y, -0.25) * about(along_z, 0.5), tolerance::exact));
  EXPECT_TRUE(near(orientation_in(plain, {.euler = euler_order_of("xyz")}), three_turns, tolerance::exact));
  EXPECT_EQ(orientation_refusal(plain, {.euler = euler_order_of("ZXZ")}),
            "keys.csv:1: no column e1, e2, e3, found 't,roll_rad,pitch_rad,yaw_rad' (option columns)");
}

TEST(EulerColumns, AreNumberedInTheOrderOfTheTurns) {
  const std::string angles = "t,e1_rad,e2_rad,e3_rad\n0,0.5,-0.25,2\n";
  EXPECT_TRUE(near(orientation_in(angles, {.euler = euler_order_of("ZYX")}), three_turns, tolerance::exact));
  EXPECT_TRUE(near(orientation_in(angles, {.euler = euler_order_of("zyx")}),
                   about(along_x, 2.0) * about(along_y, -0.25) * about(along_z, 0.5), tolerance::exact));
  EXPECT_TRUE(near(orientation_in(angles, {.euler = euler_order_of("ZXZ")}),
                   about(along_z, 0.5) * about(along_x, -0.25) * about(along_z, 2.0), tolerance::exact));
  EXPECT_EQ(orientation_refusal(angles),
            "keys.csv:1: found e1, e2, e3, wanted the order of these turns as well, such as ZYX, or zyx about the axes "
            "of the "
            "world (option euler)");
}

TEST(EulerColumns, MayHaveOtherNames) {
  EXPECT_TRUE(near(orientation_in("t,phi_deg,theta_deg,psi_deg\n0,90,0,0\n", {.euler = euler_order_of("ZXZ")},
                                  {{"e1", "phi_deg"}, {"e2", "theta_deg"}, {"e3", "psi_deg"}}),
                   about(along_z, pi / 2), tolerance::exact));
}

TEST(MatrixColumns, AreRowsOfTheMatrixFromBodyToWorld) {
  // The body's x axis points along the world's y axis: the first column is (0, 1, 0).
  EXPECT_TRUE(near(orientation_in("t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,0,-1,0,1,0,0,0,0,1\n"),
                   about(along_z, pi / 2), tolerance::exact));
}

TEST(MatrixColumns, MustHoldARotation) {
  const std::string header = "t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n";
  EXPECT_EQ(orientation_refusal(header + "0,1,0,0,0,1,0,0,0,1\n1,1,0.01,0,0,1,0,0,0,1\n"),
            "keys.csv:3: key 1: the matrix is no rotation: its transpose times itself is off by 0.01 from 1, wanted at "
            "most 0.001; `normalise` takes the nearest rotation");
  EXPECT_EQ(orientation_refusal(header + "0,1,0,0,0,1,0,0,0,-1\n"),
            "keys.csv:2: key 0: the matrix is a reflection: its determinant is -1, wanted 1");
  EXPECT_EQ(
      orientation_refusal(header + "0,0,0,0,0,0,0,0,0,0\n"),
      "keys.csv:2: key 0: the matrix is no rotation: its transpose times itself is off by 1 from 1, wanted at most "
      "0.001");
  EXPECT_EQ(orientation_refusal(header + "0,nan,0,0,0,1,0,0,0,1\n"),
            "keys.csv:2:2: key 0: found 'nan', wanted a finite number (option drop_invalid)");
  EXPECT_EQ(orientation_refusal("t,r11,r12,r13,r21,r22,r23,r31,r32\n0,1,0,0,0,1,0,0,0\n"),
            "keys.csv:1: no column r33, found 't,r11,r12,r13,r21,r22,r23,r31,r32' (option columns)");
  EXPECT_TRUE(near(orientation_in(header + "0,1.0004,0,0,0,1,0,0,0,1\n"), Eigen::Quaterniond::Identity(), 1e-15));
}

TEST(RotationVectorColumns, AreAxisTimesAngle) {
  EXPECT_TRUE(
      near(orientation_in("t,rx,ry,rz\n0,1,2,-2\n"), about({1.0 / 3, 2.0 / 3, -2.0 / 3}, 3.0), tolerance::exact));
  EXPECT_TRUE(near(orientation_in("t,rx_deg,ry_deg,rz_deg\n0,0,90,0\n"), about(along_y, pi / 2), tolerance::exact));
  EXPECT_TRUE(near(orientation_in("t,rx,ry,rz\n0,0,0,5\n"), quaternion_wxyz(std::cos(2.5), 0.0, 0.0, std::sin(2.5)),
                   tolerance::exact));  // longer than π: the sign is kept
}

TEST(OrientationColumns, AreQuaternionsWhereThereAreAny) {
  const std::string both = "t,qw,qx,qy,qz,roll,pitch,yaw,r11\n0,0,0,0,1,9,9,9,9\n";
  EXPECT_EQ(orientation_in(both), quaternion_wxyz(0.0, 0.0, 0.0, 1.0));
  EXPECT_TRUE(near(orientation_in("t,qw,qx,qy,qz,rx,ry,rz\n0,0,0,0,1,0,0.5,0\n",
                                  {.representation = Representation::rotation_vector}),
                   about(along_y, 0.5), tolerance::exact));
  EXPECT_TRUE(near(
      orientation_in("t,qw,qx,qy,qz,roll_rad,pitch_rad,yaw_rad\n0,0,0,0,1,0,0.5,0\n", {.euler = euler_order_of("ZYX")}),
      about(along_y, 0.5), tolerance::exact));
}

TEST(OrientationColumns, OfSeveralOtherKindsWantAChoice) {
  const std::string both = "t,roll_rad,pitch_rad,yaw_rad,rx,ry,rz\n0,0,0.5,0,1,0,0\n";
  EXPECT_EQ(orientation_refusal(both),
            "keys.csv:1: yaw, rx could each be the orientation, wanted one form of it (option representation)");
  EXPECT_TRUE(
      near(orientation_in(both, {.representation = Representation::euler}), about(along_y, 0.5), tolerance::exact));
  EXPECT_TRUE(near(orientation_in(both, {.representation = Representation::rotation_vector}), about(along_x, 1.0),
                   tolerance::exact));
}

TEST(OrientationColumns, RefuseOptionsThatContradictEachOther) {
  EXPECT_EQ(
      orientation_refusal("t,qw,qx,qy,qz\n0,1,0,0,0\n", {.angle_unit = AngleUnit::degrees}, ErrorCode::bad_argument),
      "[angle_unit] keys.csv:1: found an orientation in qw, qx, qy, qz, wanted Euler angles");
  EXPECT_EQ(orientation_refusal("t,rx,ry,rz\n0,1,0,0\n",
                                {.representation = Representation::matrix, .euler = euler_order_of("ZYX")},
                                ErrorCode::bad_argument),
            "[euler] keys.csv:1: found a second option that says where the orientation is, wanted one of them (option "
            "representation)");
}

TEST(OrientationColumns, AreConjugatedInEveryForm) {
  const auto file = read_keys(TextFile("t,rx,ry,rz\n0,0,0.5,0\n").path(), {.conjugate = true});
  ASSERT_TRUE(file);
  EXPECT_TRUE(near(file->data.orientations[0], about(along_y, -0.5), tolerance::exact));
}

struct Form {
  OrientationForm form;
  std::string names;
};

TEST(OrientationForm, IsReadBackAsItWasWritten) {
  const std::vector<Form> forms{
      {{}, "qw,qx,qy,qz"},
      {{.representation = Representation::euler}, "roll_deg,pitch_deg,yaw_deg"},
      {{.representation = Representation::euler, .unit = AngleUnit::radians}, "roll_rad,pitch_rad,yaw_rad"},
      {{.representation = Representation::euler, .order = *euler_order_of("zyx")}, "e1_deg,e2_deg,e3_deg"},
      {{.representation = Representation::euler, .order = *euler_order_of("ZXZ"), .unit = AngleUnit::radians},
       "e1_rad,e2_rad,e3_rad"},
      {{.representation = Representation::matrix}, "r11,r12,r13,r21,r22,r23,r31,r32,r33"},
      {{.representation = Representation::rotation_vector}, "rx,ry,rz"}};
  for (const auto& [form, names] : forms) {
    const ScratchDirectory directory;
    const std::string path = directory.file("out.csv");
    auto writer = SampleWriter::open(path, {.form = form});
    ASSERT_TRUE(writer);
    const auto rotations = testing_support::specimen_rotation_vectors();
    for (std::size_t i = 0; i < rotations.size(); ++i)
      ASSERT_TRUE(writer->write(Decimal::from_double(static_cast<double>(i)),
                                {.motion = {.orientation = exp<double>(rotations[i])}}));
    ASSERT_TRUE(writer->finish());
    EXPECT_TRUE(test::content_of(path).starts_with("t," + names + "\n")) << names;

    OrientationReading reading;
    if (names.starts_with("e1")) reading.euler = form.order;
    const auto file = read_keys(path, {.orientation = reading});

    ASSERT_TRUE(file) << describe(file.error());
    for (std::size_t i = 0; i < rotations.size(); ++i)
      EXPECT_LE(angular_distance(file->data.orientations[i], exp<double>(rotations[i])), 2 * tolerance::algebra)
          << names << " " << rotations[i].transpose();
  }
}

}}  // namespace orispline::io
