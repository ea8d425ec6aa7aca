// SPDX-License-Identifier: Apache-2.0
// rotation-spline is SciPy's RotationSpline: tests/data/scipy_rotation_spline.csv, which `tools/make_golden.py
// rotation_spline` made.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Between two double-precision solutions of the same equations.
constexpr double agreement = 1e-9;

std::vector<DataTable::Row> rows_of(const DataTable& table, std::string_view track, std::string_view kind) {
  auto rows = table.rows_where("track", track);
  std::erase_if(rows, [kind](const DataTable::Row& row) { return row.text("kind") != kind; });
  return rows;
}

Eigen::Quaterniond orientation_of(const DataTable::Row& row) { return row.quaternion("qw", "qx", "qy", "qz"); }

Keyframes keys_of(const std::vector<DataTable::Row>& rows) {
  KeyframeData data;
  for (const auto& row : rows) {
    data.times.push_back(row.number("t"));
    data.orientations.push_back(orientation_of(row));
  }
  return Keyframes::make(std::move(data)).value();
}

/// SciPy gives either of the two quaternions of an orientation: the one on our side.
Eigen::Quaterniond on_the_side_of(const Eigen::Quaterniond& ours, const Eigen::Quaterniond& q) {
  return q.dot(ours) < 0.0 ? Eigen::Quaterniond(-q.coeffs()) : q;
}

class RotationSplineOfSciPy : public testing::TestWithParam<const char*> {};

TEST_P(RotationSplineOfSciPy, HasTheSameOrientationsRatesAndAccelerations) {
  const DataTable table("scipy_rotation_spline.csv");
  const auto keys = rows_of(table, GetParam(), "key"), motions = rows_of(table, GetParam(), "motion");
  ASSERT_EQ(keys.size(), 8u);
  ASSERT_EQ(motions.size(), 15u);
  const auto curve = make_curve("rotation-spline", keys_of(keys));
  ASSERT_TRUE(curve) << describe(curve.error());
  for (const auto& row : motions) {
    SCOPED_TRACE("t = " + row.text("t"));
    const Motion ours = curve->motion(row.number("t"));
    EXPECT_TRUE(near(ours.orientation, on_the_side_of(ours.orientation, orientation_of(row)), agreement));
    EXPECT_TRUE(near(ours.angular_velocity, row.vector("wx", "wy", "wz"), agreement));
    EXPECT_TRUE(near(ours.angular_acceleration, row.vector("ax", "ay", "az"), agreement));
  }
}

INSTANTIATE_TEST_SUITE_P(Tracks, RotationSplineOfSciPy, testing::Values("smooth", "uneven", "large_steps"),
                         [](const auto& test) { return std::string(test.param); });

}}  // namespace orispline
