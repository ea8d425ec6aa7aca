// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>

#include "io/text_file.hpp"
#include "support/places.hpp"

// Recordings that are not part of the project, for their licences differ: read where they lie beside it.

namespace orispline::io { namespace {

using test::text_of;

class RealFile : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const std::string data = path_of(""); !std::filesystem::exists(data)) GTEST_SKIP() << "no " << data;
  }
  static std::string path_of(std::string_view name) { return testing_support::beside_project("data/").append(name); }
};

TEST_F(RealFile, FlightLogWithBodyRates) {
  const auto file = read_keys(path_of("flight/px4_quad_sample_attitude.csv"));
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->data.times.size(), 6461u);
  EXPECT_EQ(file->data.times[1], 0.076);
  EXPECT_EQ(file->data.orientations[0].w(), 0.954590619);
  EXPECT_EQ(file->data.angular_velocities[0], Eigen::Vector3d(-0.000425926642, 0.000473720022, 0.000837185187));
  EXPECT_TRUE(Keyframes::make(file->data));
}

TEST_F(RealFile, OpticalTruthWithDropOuts) {
  const std::string path = path_of("imu/broad_06_undisturbed_fast_rotation_A_40s.csv");
  ReadOptions options{.columns = {{"qw", "opt_qw"},
                                  {"qx", "opt_qx"},
                                  {"qy", "opt_qy"},
                                  {"qz", "opt_qz"},
                                  {"wx", "gyr_x_rad_s"},
                                  {"wy", "gyr_y_rad_s"},
                                  {"wz", "gyr_z_rad_s"}}};
  const auto refused = read_keys(path, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(text_of(refused.error()),
            "broad_06_undisturbed_fast_rotation_A_40s.csv:5620:2: key 5618: found 'nan', wanted a finite number "
            "(option drop_invalid)");

  options.drop_invalid = true;
  const auto file = read_keys(path, options);
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->repairs.invalid_dropped, 17u);
  EXPECT_EQ(file->data.times.size(), 11428u - 17u);
  EXPECT_TRUE(Keyframes::make(file->data));
}

TEST_F(RealFile, CameraTrajectoryWithADuplicateTime) {
  const std::string path = path_of("trajectory/tum_fr2_desk_groundtruth.txt");
  const auto refused = read_keys(path);
  ASSERT_FALSE(refused);
  EXPECT_EQ(text_of(refused.error()),
            "tum_fr2_desk_groundtruth.txt:10863: key 10859: duplicate time 1311868229.5760, as in line 10862, wanted "
            "increasing times; the row is turned by 0.612° from that one (option drop_duplicates)");

  const auto file = read_keys(path, {.drop_duplicates = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->format, &tum_format);
  EXPECT_EQ(file->repairs.duplicates_dropped, 1u);
  EXPECT_EQ(file->data.times.size(), 20956u);
  EXPECT_EQ(file->epoch.to_string(), "1311868163.8697");
  EXPECT_TRUE(Keyframes::make(file->data));
}

TEST_F(RealFile, SpacecraftAttitudeInTicksAndConjugate) {
  const auto file =
      read_keys(path_of("spacecraft/mro_ck_sliced_-74000.csv"),
                {.columns = {{"t", "sclk_ticks"}, {"qw", "q0_w"}, {"qx", "q1"}, {"qy", "q2"}, {"qz", "q3"}},
                 .time_scale = Decimal::parse("0.00390625").value(),
                 .conjugate = true});
  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->data.times.size(), 2242u);
  EXPECT_EQ(file->epoch.to_string(), "852245780.28515625");
  EXPECT_EQ(file->data.times[1], 0.092031015625);  // 23.55994 / 256
  EXPECT_EQ(file->data.orientations[0],
            quaternion_wxyz(0.3936574190256197, 0.6242205328301158, -0.4572318428302591, 0.4963079736830946));
  EXPECT_TRUE(file->data.angular_velocities.empty());  // wx_ref_rad_s is in the base frame
  EXPECT_TRUE(Keyframes::make(file->data));
}

}}  // namespace orispline::io
