// SPDX-License-Identifier: Apache-2.0
// Files as people have them: other names of columns, units in brackets, clocks that count micro- or nanoseconds, digits
// typed by hand.
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/time_column.hpp>
#include <orispline/io/track_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::text_of;
using test::TextFile;

KeyFile keys_in(const std::string& content, const ReadOptions& options = {}) {
  auto file = read_keys(TextFile(content).path(), options);
  EXPECT_TRUE(file) << describe(file.error());
  return file ? std::move(*file) : KeyFile();
}

std::string refusal_of(const std::string& content, const ReadOptions& options = {}) {
  return text_of(read_keys(TextFile(content).path(), options).error());
}

TEST(Positions, HaveTheNamesThatOthersGiveThem) {
  for (const std::string names : {"px,py,pz", "tx,ty,tz", "x,y,z", "x_m,y_m,z_m", "x [m],y [m],z [m]"}) {
    const auto file = keys_in("timestamp," + names + ",qx,qy,qz,qw\n1,2,3,4,0,0,0,1\n");
    ASSERT_EQ(file.data.positions.size(), 1U) << names;
    EXPECT_EQ(file.data.positions[0], Eigen::Vector3d(2.0, 3.0, 4.0)) << names;
    EXPECT_TRUE(file.ignored_columns.empty());
  }
  EXPECT_EQ(keys_in("t,x (mm),y (mm),z (mm),qw,qx,qy,qz\n0,1,2,3,1,0,0,0\n").data.positions[0],
            Eigen::Vector3d(0.001, 0.002, 0.003));
}

TEST(Positions, AreThoseOfTheFirstNamesThatAreAllThere) {
  const auto both = keys_in("t,x,y,z,px,py,pz,qw,qx,qy,qz\n0,7,8,9,1,2,3,1,0,0,0\n");
  EXPECT_EQ(both.data.positions[0], Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(both.ignored_columns, (std::vector<std::string>{"x", "y", "z"}));
  const auto some = keys_in("t,x,y,tz,qw,qx,qy,qz\n0,7,8,9,1,0,0,0\n");
  EXPECT_TRUE(some.data.positions.empty());
  EXPECT_EQ(some.ignored_columns, (std::vector<std::string>{"x", "y", "tz"}));
}

TEST(Positions, AreNoColumnsThatWereMapped) {
  const auto mapped =
      keys_in("t,x,y,z,w\n0,0,0,0,1\n", {.columns = {{"qx", "x"}, {"qy", "y"}, {"qz", "z"}, {"qw", "w"}}});
  EXPECT_TRUE(mapped.data.positions.empty());
  EXPECT_NE(refusal_of("t,x (m),x_m,y,z,qw,qx,qy,qz\n0,1,1,2,3,1,0,0,0\n").find("could both be x"), std::string::npos);
}

TEST(UnitsInBrackets, AreThoseOfSuffixes) {
  const std::string rows = "\n0,1,0,0,0,180,0,0\n";
  for (const std::string unit : {" (deg/s)", "(°/s)", " [deg/s]", "_deg_s"}) {
    const auto file = keys_in("t,qw,qx,qy,qz,wx" + unit + ",wy" + unit + ",wz" + unit + rows);
    ASSERT_EQ(file.data.angular_velocities.size(), 1U) << unit;
    EXPECT_NEAR(file.data.angular_velocities[0].x(), 3.141592653589793, 1e-15) << unit;
  }
  EXPECT_EQ(keys_in("t,qw [],qx [],qy [],qz []\n0,1,0,0,0\n").data.orientations[0].w(), 1.0);
}

TEST(TimeColumn, SaysItsUnitInManyWays) {
  for (const auto& [name, exponent] :
       {std::pair("time (us)", -6), std::pair("stamp_us", -6), std::pair("time [µs]", -6), std::pair("usec", -6),
        std::pair("timestamp_nsec", -9), std::pair("nsec", -9), std::pair("t_ns", -9), std::pair("time_msec", -3),
        std::pair("seconds", 0), std::pair("stamp", 0), std::pair("time (s)", 0)}) {
    const auto file = keys_in(std::string(name) + ",qw,qx,qy,qz\n5,1,0,0,0\n");
    EXPECT_EQ(file.epoch, Decimal::parse("5").value() * Decimal::power_of_ten(exponent)) << name;
    EXPECT_TRUE(file.warnings.empty());
  }
}

TEST(TimeColumn, IsOfTheUnitInWhichItsTimesAreThoseOfToday) {
  for (const auto& [first, epoch, name] : {std::tuple("1700000000000", "1700000000", "milliseconds"),
                                           std::tuple("1700000000000001", "1700000000.000001", "microseconds"),
                                           std::tuple("1403636580838555648", "1403636580.838555648", "nanoseconds"),
                                           std::tuple("100000000000", "100000000", "milliseconds"),
                                           std::tuple("-100000000000", "-100000000", "milliseconds")}) {
    for (const std::string head : {"t", "timestamp"}) {
      const auto file = keys_in(head + ",qw,qx,qy,qz\n" + first + ",1,0,0,0\n");
      EXPECT_EQ(file.epoch.to_string(), epoch);
      ASSERT_EQ(file.warnings.size(), 1U);
      EXPECT_EQ(file.warnings[0].code, "time_unit_by_size");
      EXPECT_EQ(file.warnings[0].message, "the times are taken as " + std::string(name) + ", for the first one is " +
                                              first + "; set `time_scale` if they are not");
    }
  }
  const std::string row = "1700000000000000,1,0,0,0\n";
  EXPECT_EQ(keys_in("t_s,qw,qx,qy,qz\n" + row).epoch.to_string(), "1700000000000000");
  EXPECT_EQ(keys_in("t,qw,qx,qy,qz\n" + row, {.time_scale = Decimal::power_of_ten(0)}).epoch.to_string(),
            "1700000000000000");
  // A column that was named by the user is one of times like all others, and its own name may state the unit.
  const auto named = keys_in("sclk,qw,qx,qy,qz\n" + row, {.columns = {{"t", "sclk"}}});
  EXPECT_EQ(named.epoch.to_string(), "1700000000");
  EXPECT_EQ(named.warnings.size(), 1U);
  EXPECT_EQ(keys_in("sclk_s,qw,qx,qy,qz\n" + row, {.columns = {{"t", "sclk_s"}}}).epoch.to_string(),
            "1700000000000000");
  const auto seconds = keys_in("t,qw,qx,qy,qz\n99999999999.9,1,0,0,0\n");
  EXPECT_EQ(seconds.epoch.to_string(), "99999999999.9");
  EXPECT_TRUE(seconds.warnings.empty());
}

TEST(TimeColumn, IsDecidedByTheEarliestTimeOfRowsThatAreSorted) {
  const auto file = keys_in("t,qw,qx,qy,qz\n100000000001,1,0,0,0\n99999999999,1,0,0,0\n", {.sort = true});
  EXPECT_EQ(file.epoch.to_string(), "99999999999");
  EXPECT_TRUE(file.warnings.empty());
}

TEST(CcsdsAttitude, IsBodyToWorldInDirectionA2BFromAnOuterFrame) {
  // v1_last_a2b.aem and v1_last_b2a.aem of the data, and where Orekit 12.2 sees the body's x axis.
  const std::string rows = "t,qx,qy,qz,qw\n0,0.1,0.2,0.3,0.92736184955\n";
  const auto x_axis = [](const KeyFile& file) -> Eigen::Vector3d {
    return file.data.orientations[0] * Eigen::Vector3d::UnitX();
  };
  EXPECT_LE((x_axis(keys_in(rows)) - Eigen::Vector3d(0.74, 0.596417110, -0.310944740)).norm(), 1e-9);
  EXPECT_LE((x_axis(keys_in(rows, {.conjugate = true})) - Eigen::Vector3d(0.74, -0.516417110, 0.430944740)).norm(),
            1e-9);
}

TEST(NormsOfFiles, NearOneAreMadeOneAndCounted) {
  const auto file = keys_in("t,qw,qx,qy,qz\n0,0.9,0.44,0,0\n1,1.0005,0,0,0\n2,0,1.0199,0,0\n");
  EXPECT_EQ(file.repairs.normalised, 2U);
  EXPECT_NEAR(file.repairs.largest_norm_error, 0.0199, 1e-12);
  EXPECT_NEAR(file.data.orientations[0].norm(), 1.0, 1e-15);
  EXPECT_EQ(file.data.orientations[1].w(), 1.0005);  // left to Keyframes
  EXPECT_EQ(file.data.orientations[2].x(), 1.0);
}

TEST(NormsOfFiles, FartherOffAreRefusedUnlessAnyIsWanted) {
  const std::string rows = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.6,0.6,0,0.6\n2,0,0,3e-200,4e-200\n";
  EXPECT_EQ(refusal_of(rows),
            "keys.csv:3: key 1: the quaternion has norm 1.03923, wanted 1 within 0.02 (option norms)");
  const auto any = keys_in(rows, {.norms = Norms::any});
  EXPECT_EQ(any.repairs.normalised, 2U);
  EXPECT_NEAR(any.data.orientations[1].x(), std::sqrt(1.0 / 3.0), 1e-15);
  EXPECT_NEAR(any.data.orientations[2].z(), 0.8, 1e-15);
  const auto as_they_are = keys_in(rows, {.norms = Norms::as_they_are});
  EXPECT_EQ(as_they_are.repairs.normalised, 0U);
  EXPECT_EQ(as_they_are.data.orientations[1].x(), 0.6);
  for (const Norms norms : {Norms::near_one, Norms::any})
    EXPECT_EQ(refusal_of("t,qw,qx,qy,qz\n0,0,0,0,0\n", {.norms = norms}),
              "keys.csv:2: key 0: the quaternion is zero, wanted a rotation (option drop_invalid)");
}

// What Euler angles say of turns.

std::vector<Warning> warnings_of_yaws(const std::vector<double>& yaws, Signs signs = Signs::shortest) {
  std::string content = "t,yaw_deg,pitch_deg,roll_deg\n";
  for (std::size_t i = 0; i < yaws.size(); ++i) content += std::to_string(i) + "," + std::to_string(yaws[i]) + ",0,0\n";
  const auto file = read_track(TextFile(content).path(), {}, signs);
  EXPECT_TRUE(file) << describe(file.error());
  return file ? file->warnings : std::vector<Warning>();
}

double lost_steps(const std::vector<double>& yaws, Signs signs = Signs::shortest) {
  const auto warnings = warnings_of_yaws(yaws, signs);
  if (warnings.empty()) return 0.0;
  EXPECT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "lost_turns");
  return warnings[0].number("steps");
}

TEST(EulerTurns, ThatAreLostAreWarnedOf) {
  EXPECT_EQ(lost_steps({0, 350}), 1);
  EXPECT_EQ(lost_steps({0, 360}), 1);
  EXPECT_EQ(lost_steps({0, 720}), 1);
  EXPECT_EQ(lost_steps({0, 360, 720}), 2);
  EXPECT_EQ(lost_steps({0, 360, 360}), 1);
  EXPECT_EQ(lost_steps({0, 90, 360}), 1);
  EXPECT_EQ(lost_steps({90, 0, -200, -190}), 1);
}

TEST(EulerTurns, OfHalfATurnAreKept) {
  EXPECT_EQ(lost_steps({0, 90, 180, 270, 360, 450}), 0);
  EXPECT_EQ(lost_steps({0, 179, 2, -177}), 0);
}

TEST(EulerTurns, ThatBeginAnewLoseNothing) {
  EXPECT_EQ(lost_steps({150, 165, 180, -165, -150}), 0);
  EXPECT_EQ(lost_steps({10, 355, 340}), 0);
  EXPECT_EQ(lost_steps({179.9, -179.9, 179.8, -179.95}), 0);
  EXPECT_EQ(lost_steps({180, -180, 180}), 0);
  EXPECT_EQ(lost_steps({350, 355, 0, 5, 10}), 0);
}

TEST(EulerTurns, AreKeptBySignsAsGivenUpToAFullOne) {
  EXPECT_EQ(lost_steps({0, 350, 180}, Signs::as_given), 0);
  EXPECT_EQ(lost_steps({0, 350, 710, 730}, Signs::as_given), 1);
}

TEST(EulerTurns, AreWarnedOfWithTheirPlaceAndTheCure) {
  const auto warnings = warnings_of_yaws({5, 10, 360, 20, 370});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].where.key, 1U);
  EXPECT_EQ(warnings[0].where.line, 3U);
  EXPECT_EQ(warnings[0].message,
            "3 steps of Euler angles, the first with yaw from 10° to 360°, are turned the short way; set `signs` to "
            "as-given to turn as the angles say");
  EXPECT_EQ(
      warnings_of_yaws({0, 360})[0].message,
      "1 step of Euler angles, the first with yaw from 0° to 360°, is turned the short way; put keys in between and "
      "set `signs` to as-given to turn as the angles say: a step must turn by less than 360°");
}

// A file beside another.

TEST(FileBesideAnother, IsReadByTheSameOptionsAsFarAsTheyFit) {
  const TextFile keys("t,a,b,c\n0,0,0,0\n1,90,0,0\n", "keys.csv");
  const ReadOptions options{.columns = {{"e1", "a"}, {"e2", "b"}, {"e3", "c"}},
                            .orientation = {.euler = EulerOrder{}, .angle_unit = AngleUnit::degrees}};
  const TrackFile input = read_track(keys.path(), options).value();
  const auto orientation_in = [&](const std::string& content, const std::string& name) {
    const TextFile file(content, name);
    const auto track = read_track_beside(input, file.path(), options);
    EXPECT_TRUE(track) << describe(track.error());
    return track ? track->track.keys.orientations().back().coeffs() : Eigen::Vector4d::Zero().eval();
  };
  const Eigen::Vector4d quarter = input.track.keys.orientations().back().coeffs();
  EXPECT_EQ(orientation_in("t,a,b,c\n0,90,0,0\n", "truth.csv"), quarter);
  EXPECT_EQ(orientation_in("t,qw,qx,qy,qz\n0,0.6,0,0,0.8\n", "truth.csv"), Eigen::Vector4d(0, 0, 0.8, 0.6));
  EXPECT_EQ(orientation_in("0 1 2 3 0 0 0.8 0.6\n", "truth.tum"), Eigen::Vector4d(0, 0, 0.8, 0.6));
}

TEST(FileBesideAnother, HasItsOwnTimesWhereItStatesTheirUnit) {
  const ReadOptions options{.time_scale = Decimal::power_of_ten(-3)};
  const TextFile keys("t,qw,qx,qy,qz\n0,1,0,0,0\n1000,1,0,0,0\n", "keys.csv");
  const TrackFile input = read_track(keys.path(), options).value();
  const auto last_time = [&](const std::string& content, const std::string& name) {
    const TextFile file(content, name);
    return read_track_beside(input, file.path(), options).value().track.keys.times().back();
  };
  EXPECT_EQ(last_time("t,qw,qx,qy,qz\n0,1,0,0,0\n500,1,0,0,0\n", "truth.csv"), 0.5);
  EXPECT_EQ(last_time("t_ns,qw,qx,qy,qz\n0,1,0,0,0\n500000000,1,0,0,0\n", "truth.csv"), 0.5);
  EXPECT_EQ(last_time("0 0 0 0 0 0 0 1\n0.5 0 0 0 0 0 0 1\n", "truth.tum"), 0.5);
}

TEST(FileBesideAnother, IsRefusedForWhatItsOwnReaderSays) {
  const TextFile keys("t,qw,qx,qy,qz\n0,1,0,0,0\n", "keys.csv"), truth("t,yaw,pitch,roll\n0,1,2,3\n", "truth.csv");
  const auto refused = read_track_beside(read_track(keys.path()).value(), truth.path(), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().remedy, "angle_unit");
}

}}  // namespace orispline::io
