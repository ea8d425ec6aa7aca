// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include <orispline/io/key_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::TextFile;

TEST(Tum, ReadsTimePositionAndQuaternion) {
  for (const char* content :
       {"# timestamp tx ty tz qx qy qz qw\n1311868163.8697 1 2 3 0.5 -0.5 0.5 -0.5\n"
        "1311868163.8731 4 5 6 0 0 0 1\n",
        "1311868163.8697\t1\t2\t3\t0.5\t-0.5\t0.5\t-0.5\n1311868163.8731\t4\t5\t6\t0\t0\t0\t1\n"}) {
    const auto file = read_keys(TextFile(content, "keys.txt").path());
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->format, &tum_format);
    EXPECT_EQ(file->epoch.to_string(), "1311868163.8697");
    EXPECT_EQ(file->data.times, (std::vector<double>{0.0, 0.0034}));
    EXPECT_EQ(file->data.positions[1], Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(file->data.orientations[0], quaternion_wxyz(-0.5, 0.5, -0.5, 0.5));
    EXPECT_TRUE(file->data.angular_velocities.empty());
  }
}

TEST(Tum, IsScaledAndConjugatedLikeCsv) {
  const auto file = read_keys(TextFile("2000 0 0 0 0.5 -0.5 0.5 0.5\n", "keys.tum").path(),
                              {.time_scale = Decimal::power_of_ten(-3), .conjugate = true});
  ASSERT_TRUE(file);
  EXPECT_EQ(file->epoch.to_string(), "2");
  EXPECT_EQ(file->data.orientations[0], quaternion_wxyz(0.5, -0.5, 0.5, -0.5));
}

}}  // namespace orispline::io
