// SPDX-License-Identifier: Apache-2.0
// Rows that are read in other axes and frames than their file states them.
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <orispline/axes.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/io/file_option.hpp>
#include <orispline/io/key_reader.hpp>
#include <orispline/io/track_file.hpp>
#include <support/near.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using testing_support::near;

ReadOptions options_by(const StatedOptions& stated) {
  Reading reading;
  const auto taken = take_options(reading, stated);
  EXPECT_TRUE(taken) << describe(taken.error());
  reading.options.rate_orders = 3;
  reading.options.world_rates = true;
  return reading.options;
}

KeyframeData read_by(const StatedOptions& stated, const std::string& content) {
  auto file = read_keys(test::TextFile(content).path(), options_by(stated));
  if (!file) {
    ADD_FAILURE() << describe(file.error());
    return {};
  }
  return std::move(file->data);
}

std::string refused(const StatedOptions& stated) {
  Reading reading;
  if (const auto taken = take_options(reading, stated); !taken) return test::text_of(taken.error());
  const auto file = read_keys(test::TextFile("t,qw,qx,qy,qz\n0,1,0,0,0\n").path(), reading.options);
  EXPECT_FALSE(file);
  return file ? "" : test::text_of(file.error());
}

void expect_same(const Eigen::Quaterniond& found, const Eigen::Quaterniond& wanted, double tolerance) {
  const double sign = found.dot(wanted) < 0.0 ? -1.0 : 1.0;
  EXPECT_LE((sign * found.coeffs() - wanted.coeffs()).cwiseAbs().maxCoeff(), tolerance)
      << found.coeffs().transpose() << " (x y z w)";
}

const StatedOptions to_ros{{"world_axes", "NED:ENU"}, {"body_axes", "FRD:FLU"}};
const Eigen::Quaterniond in_ros(0.565685424949238, 0.593969696196700, -0.084852813742386, 0.565685424949238);

TEST(FramesOfFiles, TurnAllThatARowStates) {
  const KeyframeData data = read_by(to_ros,
                                    "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,ax,ay,az,jx,jy,jz\n"
                                    "0,0.8,0.36,0.48,0,1,2,3,0.1,0.2,0.3,1,2,3,4,5,6\n"
                                    "1,0.8,0.36,0.48,0,1,2,3,,,,nan,nan,nan,4,5,6\n");
  expect_same(data.orientations[0], in_ros, 1e-15);
  EXPECT_EQ(data.positions[0], Eigen::Vector3d(2, 1, -3));
  EXPECT_EQ(data.angular_velocities[0], Eigen::Vector3d(0.1, -0.2, -0.3));
  EXPECT_EQ(data.angular_accelerations[0], Eigen::Vector3d(1, -2, -3));
  EXPECT_EQ(data.angular_jerks[0], Eigen::Vector3d(4, -5, -6));
  EXPECT_TRUE(is_free(data.angular_velocities[1]));
  EXPECT_TRUE(is_free(data.angular_accelerations[1]));
}

TEST(FramesOfFiles, TurnEveryFormOfAnOrientation) {
  const Eigen::Quaterniond q(0.8, 0.36, 0.48, 0.0);
  for (const OrientationForm& form : {OrientationForm{.representation = Representation::quaternion},
                                      OrientationForm{.representation = Representation::euler},
                                      OrientationForm{.representation = Representation::matrix},
                                      OrientationForm{.representation = Representation::rotation_vector}}) {
    std::string header = "t", row = "0";
    for (const std::string& name : written_names(form)) header += "," + name;
    const OrientationNumbers numbers = numbers_of(q, form);
    for (const double number : numbers) row += formatted(",{}", number);
    expect_same(read_by(to_ros, header + "\n" + row + "\n").orientations[0], in_ros, 1e-14);
  }
}

TEST(FramesOfFiles, TurnRatesOfTheWorldByTheWorld) {
  // det(W) W ω, which is the world's rate of R' = W R Bᵀ.
  const KeyframeData data = read_by({{"world_axes", "RUF:FLU"}, {"body_axes", "RUF:FLU"}},
                                    "t,qw,qx,qy,qz,wx_world,wy_world,wz_world\n0,0.8,0.36,0.48,0,0.1,0.2,0.3\n");
  const Eigen::Vector3d world = to_world<double>(data.orientations[0], data.angular_velocities[0]);
  EXPECT_TRUE(near(world, Eigen::Vector3d(-0.3, 0.1, -0.2), 1e-15));
}

TEST(FramesOfFiles, KeepTheSignsOfAsGivenToEachOther) {
  const std::string content = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,0,0,1\n2,-1,0,0,0\n";
  const auto track = read_track(test::TextFile(content).path(), options_by(to_ros), Signs::as_given);
  ASSERT_TRUE(track);
  const auto q = track->track.keys.orientations();
  EXPECT_NEAR(q[0].dot(q[2]), -1.0, 1e-15);
}

TEST(FramesOfFiles, TurnAfterTheAxesByAnyRotation) {
  const std::string content = "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz\n0,0.8,0.36,0.48,0,1,2,3,1,0,0\n";
  const KeyframeData world = read_by({{"world_rotation", "roll_deg=0,pitch_deg=0,yaw_deg=90"}}, content);
  const Eigen::Quaterniond quarter(std::sqrt(0.5), 0, 0, std::sqrt(0.5)), q(0.8, 0.36, 0.48, 0.0);
  expect_same(world.orientations[0], quarter * q, 1e-15);
  EXPECT_TRUE(near(world.positions[0], Eigen::Vector3d(-2, 1, 3), 1e-15));
  EXPECT_EQ(world.angular_velocities[0], Eigen::Vector3d(1, 0, 0));
  const KeyframeData body =
      read_by({{"body_rotation", "qw=0.7071067811865476,qx=0,qy=0,qz=0.7071067811865476"}}, content);
  expect_same(body.orientations[0], q * quarter.conjugate(), 1e-15);
  EXPECT_EQ(body.positions[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(near(body.angular_velocities[0], Eigen::Vector3d(0, 1, 0), 1e-15));
  // Of the two the axes come first.
  const KeyframeData both =
      read_by({{"world_rotation", "rx=0,ry=0,rz=1.5707963267948966"}, {"world_axes", "NED:ENU"}}, content);
  EXPECT_TRUE(near(both.positions[0], Eigen::Vector3d(-1, 2, -3), 1e-15));
}

TEST(FramesOfFiles, TakeRotationsByNamesOrFromAFile) {
  const Eigen::Quaterniond wanted(0.8, 0, 0, 0.6);
  const auto rotation = [](const std::string& text) {
    return options_by({{"body_rotation", text}}).frames.body.rotation.value_or(Eigen::Quaterniond(0, 0, 0, 0));
  };
  for (const std::string text :
       {"qz=0.6,qw=0.8,qx=0,qy=0", "rx=0,ry=0,rz=1.2870022175865687",
        "yaw_rad=1.2870022175865687,pitch_rad=0,roll_rad=0", "euler=ZXZ,e1_rad=1,e2_rad=0,e3_rad=0.2870022175865687",
        "r11=0.28,r12=-0.96,r13=0,r21=0.96,r22=0.28,r23=0,r31=0,r32=0,r33=1"})
    expect_same(rotation(text), wanted, 1e-15);
  const test::TextFile file("# mounting\nname,qw,qx,qy,qz\ncam0,0.8,0,0,0.6\n", "mount.csv");
  expect_same(rotation(file.path()), wanted, 0.0);
}

TEST(FramesOfFiles, PutTheCameraOfWorldToCameraPosesInItsPlace) {
  const std::string content =
      "t,qw,qx,qy,qz,tx,ty,tz,wx,wy,wz\n"
      "0.0,0.7071067811865476,0.7071067811865475,-0.0,-0.0,-3.0,1.0,-2.220446049250313e-16,1,2,3\n";
  const KeyframeData data = read_by({{"inverse_poses", ""}}, content);
  EXPECT_TRUE(near(data.positions[0], Eigen::Vector3d(3, 0, 1), 1e-15));
  expect_same(data.orientations[0], {0.7071067811865476, -0.7071067811865475, 0, 0}, 0.0);
  EXPECT_EQ(data.angular_velocities[0], Eigen::Vector3d(1, 2, 3));  // of the camera in its own frame
  const KeyframeData conjugated = read_by({{"conjugate", ""}}, content);
  EXPECT_EQ(conjugated.positions[0], Eigen::Vector3d(-3.0, 1.0, -2.220446049250313e-16));
  // Then the axes: a room with z up from one with y down, and a camera that looks along -z.
  const KeyframeData turned =
      read_by({{"inverse_poses", ""}, {"world_axes", "RDF:RFU"}, {"body_axes", "RDF:RUB"}}, content);
  EXPECT_TRUE(near(turned.positions[0], Eigen::Vector3d(3, 1, 0), 1e-15));
  EXPECT_EQ(turned.angular_velocities[0], Eigen::Vector3d(1, -2, -3));
}

TEST(FramesOfFiles, AreThoseOfTheRatesInARecipe) {
  const test::TextFile file(
      "# orispline: method=rotation-spline:ends=clamped:start_rate=0.1,0.2,0.3:end_rate=1,0,0\n"
      "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0,0,0.6\n");
  const auto input = KeyInput::open(file.path(), options_by(to_ros));
  ASSERT_TRUE(input);
  EXPECT_EQ(input->recipe().method, "rotation-spline:ends=clamped:start_rate=0.1,-0.2,-0.3:end_rate=1,0,0");
  const auto track = read_track(file.path(), options_by(to_ros));
  ASSERT_TRUE(track);
  EXPECT_EQ(track->track.recipe.method, input->recipe().method);
}

TEST(FramesOfFiles, AreNoPartOfWhatIsWritten) {
  const test::TextFile file("# orispline: method=timed-c2\nt,qw,qx,qy,qz,px,py,pz\n0,0.8,0.36,0.48,0,1,2,3\n");
  const test::ScratchDirectory folder;
  const std::string path = folder.file("turned.csv");
  ReadOptions options = options_by(to_ros);
  options.keep_as_read = true;
  const auto turned = read_track(file.path(), options);
  ASSERT_TRUE(turned);
  auto output = OutputFile::open(path);
  ASSERT_TRUE(output);
  ASSERT_TRUE(write_tracks(*output, std::span(&turned->track, 1), SampleColumns{}));
  ASSERT_TRUE(output->finish());
  const auto again = read_track(path);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->track.recipe.method, "timed-c2");
  EXPECT_EQ(again->track.keys.orientations()[0].coeffs(), turned->track.keys.orientations()[0].coeffs());
  EXPECT_EQ(again->track.keys.positions()[0], Eigen::Vector3d(2, 1, -3));
}

TEST(FramesOfFiles, SayWhatTheyWant) {
  EXPECT_EQ(refused({{"world_axes", "NED:NEU"}}),
            "[world_axes] found axes of the world of which one system is right-handed and the other left-handed, and "
            "axes of the body that keep their hand, wanted a change on both sides or on none (body_axes)");
  EXPECT_EQ(refused({{"conjugate", ""}, {"inverse_poses", ""}}),
            "[inverse_poses] found `conjugate` as well, which turns the orientations back, wanted one of them");
  EXPECT_EQ(refused({{"body_rotation", "qw=1,qx=0,qy=0,qz=1"}}),
            "[body_rotation] the quaternion has norm 1.41421, wanted 1 within 0.02");
  EXPECT_EQ(refused({{"body_rotation", "qw=1,qx=0"}}),
            "[body_rotation] found qw, qx, wanted qw, qx, qy, qz, or angles such as roll_deg, pitch_deg, yaw_deg, or "
            "r11, …, r33, or rx, ry, rz [rad]");
  EXPECT_EQ(refused({{"body_rotation", "qw=1,qx=0,qy=0,qz=0,px=3"}}).substr(0, 52),
            "[body_rotation] found qw, qx, qy, qz, px, wanted qw,");
  EXPECT_EQ(refused({{"body_rotation", "qw=1,qx=0,qy=zero,qz=0"}}), "[body_rotation] found qy=zero, wanted a number");
  EXPECT_EQ(refused({{"body_rotation", "qw=1,qx"}}), "[body_rotation] found 'qx', wanted NAME=NUMBER");
  EXPECT_EQ(refused({{"world_rotation", "-"}}),
            "[world_rotation] found '-', wanted NAME=NUMBER,... with qw, qx, qy, qz, or angles such as roll_deg, "
            "pitch_deg, yaw_deg, or r11, …, r33, or rx, ry, rz [rad], or a file of one row");
  const test::TextFile two("qw,qx,qy,qz\n1,0,0,0\n1,0,0,0\n", "two.csv"), bare("1,0,0,0\n", "bare.csv"),
      none("qw,qx,qy,qz\n", "none.csv");
  EXPECT_EQ(refused({{"world_rotation", two.path()}}),
            "[world_rotation] two.csv:3: found a second row of numbers, wanted one rotation");
  EXPECT_EQ(refused({{"world_rotation", bare.path()}}).substr(0, 63),
            "[world_rotation] bare.csv:1: found no header, wanted one with qw");
  EXPECT_EQ(refused({{"world_rotation", none.path()}}).substr(0, 45), "[world_rotation] none.csv: found no numbers, ");
  EXPECT_EQ(refused({{"world_rotation", "not_there.csv"}}).substr(0, 31), "[world_rotation] not_there.csv:");
}

}}  // namespace orispline::io
