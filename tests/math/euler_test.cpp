// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/euler.hpp>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::Dice;
using testing_support::near;
using testing_support::pi;

struct NamedOrder {
  std::string name;
  EulerOrder order;
};

std::vector<NamedOrder> all_orders() {
  std::vector<NamedOrder> orders;
  for (const std::string_view letters : {"XYZ", "xyz"})
    for (const char a : letters)
      for (const char b : letters)
        for (const char c : letters)
          if (const auto order = euler_order_of(std::string{a, b, c})) orders.push_back({{a, b, c}, *order});
  return orders;
}

EulerOrder order_of(std::string_view name) { return euler_order_of(name).value(); }

/// Written out: what a turn about x, y or z does to the axes.
Eigen::Matrix3d turn(int axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix3d m;
  if (axis == 0) m << 1, 0, 0, 0, c, -s, 0, s, c;
  if (axis == 1) m << c, 0, s, 0, 1, 0, -s, 0, c;
  if (axis == 2) m << c, -s, 0, s, c, 0, 0, 0, 1;
  return m;
}

/// The end of the range of the second angle, where the first and the third turn about one line.
double upper_lock(const EulerOrder& order) { return order.is_proper() ? pi : pi / 2; }
double lower_lock(const EulerOrder& order) { return order.is_proper() ? 0.0 : -pi / 2; }

Eigen::Vector3d angles_in_range(const EulerOrder& order, Dice& dice) {
  return {dice.between(-pi, pi), dice.between(lower_lock(order) + 0.01, upper_lock(order) - 0.01),
          dice.between(-pi, pi)};
}

double distance(const EulerOrder& order, const Eigen::Vector3d& angles, const Eigen::Quaterniond& q) {
  return angular_distance(quaternion_from_euler(order, angles), q);
}

TEST(EulerOrder, HasTwelveOrdersAboutTheBodyAndTwelveAboutTheWorld) {
  const auto orders = all_orders();
  EXPECT_EQ(orders.size(), 24u);
  EXPECT_EQ(std::ranges::count_if(orders, [](const auto& o) { return o.order.is_proper(); }), 12);
  for (const auto& [name, order] : orders) {
    const bool is_upper = std::isupper(static_cast<unsigned char>(name[0])) != 0;
    EXPECT_EQ(order.axes, is_upper ? EulerOrder::Axes::of_body : EulerOrder::Axes::of_world) << name;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ("xyz"[static_cast<std::size_t>(order.turns[i])], std::tolower(static_cast<unsigned char>(name[i])));
  }
  EXPECT_EQ(order_of("ZYX"), EulerOrder{});
}

TEST(EulerOrder, IsNothingElse) {
  for (const char* name : {"", "X", "XY", "XXY", "XYY", "XyZ", "xYz", "ZYXZ", "ABC", "321", "ZYW", "zyw", " ZYX"})
    EXPECT_FALSE(euler_order_of(name)) << name;
}

TEST(Euler, IsTheProductOfItsTurns) {
  Dice dice(31);
  for (const auto& [name, order] : all_orders())
    for (int n = 0; n < 20; ++n) {
      const Eigen::Vector3d angles = 4.0 * dice.vector();
      const Eigen::Matrix3d a = turn(order.turns[0], angles[0]), b = turn(order.turns[1], angles[1]),
                            c = turn(order.turns[2], angles[2]);
      const Eigen::Matrix3d wanted = order.axes == EulerOrder::Axes::of_body ? a * b * c : c * b * a;
      EXPECT_TRUE(near(quaternion_from_euler(order, angles).toRotationMatrix(), wanted, tolerance::algebra)) << name;
    }
}

TEST(Euler, OfRollPitchYawIsTheTextbookFormula) {
  Dice dice(32);
  for (int n = 0; n < 100; ++n) {
    const Eigen::Quaterniond q = exp<double>(3.0 * dice.vector());
    const Eigen::Matrix3d r = q.toRotationMatrix();
    const Eigen::Vector3d yaw_pitch_roll(std::atan2(r(1, 0), r(0, 0)), -std::asin(r(2, 0)),
                                         std::atan2(r(2, 1), r(2, 2)));
    EXPECT_TRUE(near(euler_angles(order_of("ZYX"), q), yaw_pitch_roll, tolerance::series));
    const Eigen::Vector3d precession_nutation_spin(std::atan2(r(0, 2), -r(1, 2)), std::acos(r(2, 2)),
                                                   std::atan2(r(2, 0), r(2, 1)));
    EXPECT_TRUE(near(euler_angles(order_of("ZXZ"), q), precession_nutation_spin, tolerance::series));
  }
}

TEST(Euler, AgreesWithSciPy) {
  const DataTable table("euler.csv");
  ASSERT_EQ(table.size(), 24u * 5u);
  for (const auto& row : table.rows()) {
    const EulerOrder order = order_of(row.text("order"));
    const Eigen::Quaterniond q = row.quaternion("qw", "qx", "qy", "qz");
    const Eigen::Vector3d angles = row.vector("e1", "e2", "e3");
    EXPECT_TRUE(near(euler_angles(order, q), angles, tolerance::algebra)) << row.text("order");
    EXPECT_LE(distance(order, angles, q), tolerance::algebra) << row.text("order");
  }
}

TEST(Euler, GivesBackAnglesWithinTheirRanges) {
  Dice dice(33);
  for (const auto& [name, order] : all_orders())
    for (int n = 0; n < 50; ++n) {
      const Eigen::Vector3d angles = angles_in_range(order, dice);
      const Eigen::Quaterniond q = quaternion_from_euler(order, angles);
      EXPECT_TRUE(near(euler_angles(order, q), angles, tolerance::algebra)) << name;
      EXPECT_TRUE(near(euler_angles(order, Eigen::Quaterniond(-q.coeffs())), angles, tolerance::algebra)) << name;
    }
}

TEST(Euler, GivesBackEveryOrientation) {
  for (const auto& [name, order] : all_orders())
    for (const Eigen::Vector3d& phi : testing_support::specimen_rotation_vectors()) {
      const Eigen::Quaterniond q = exp<double>(phi);
      const Eigen::Vector3d angles = euler_angles(order, q);
      EXPECT_LE(distance(order, angles, q), tolerance::algebra) << name << " " << phi.transpose();
      EXPECT_LE(std::abs(angles[0]), pi);
      EXPECT_LE(std::abs(angles[2]), pi);
      EXPECT_LE(angles[1], upper_lock(order));
      EXPECT_GE(angles[1], lower_lock(order));
    }
}

TEST(Euler, HasAThirdAngleOfZeroAtAGimbalLock) {
  Dice dice(34);
  for (const auto& [name, order] : all_orders())
    for (const double lock : {lower_lock(order), upper_lock(order)})
      for (int n = 0; n < 20; ++n) {
        const Eigen::Quaterniond q = quaternion_from_euler(order, {dice.between(-pi, pi), lock, dice.between(-pi, pi)});
        const Eigen::Vector3d angles = euler_angles(order, q);
        EXPECT_EQ(angles[2], 0.0) << name;
        EXPECT_EQ(angles[1], lock) << name;
        EXPECT_LE(distance(order, angles, q), tolerance::algebra) << name;
        const Eigen::Quaterniond negated(-q.coeffs());
        EXPECT_TRUE(near(euler_angles(order, negated), angles, tolerance::exact)) << name;
      }
}

TEST(Euler, StaysAccurateHoweverNearAGimbalLock) {
  Dice dice(35);
  for (const auto& [name, order] : all_orders())
    for (double gap = 1e-1; gap > 1e-17; gap *= 0.1)
      for (const double second : {lower_lock(order) + gap, upper_lock(order) - gap}) {
        const Eigen::Quaterniond q =
            quaternion_from_euler(order, {dice.between(-pi, pi), second, dice.between(-pi, pi)});
        const Eigen::Vector3d angles = euler_angles(order, q);
        EXPECT_LE(distance(order, angles, q), tolerance::algebra) << name << " at " << gap;
        EXPECT_NEAR(angles[1], second, tolerance::algebra) << name << " at " << gap;
      }
}

}}  // namespace orispline
