// SPDX-License-Identifier: Apache-2.0
// Every family against 60-digit values: tests/data/golden, made by `tools/make_golden.py golden
// rational biarcs monotone`.
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/golden_case.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::MotionTolerance;
using testing_support::near;

struct GoldenFamily {
  const char* name;
  std::size_t cases, rows;  ///< as many as the reference has: none may get lost on the way
  MotionTolerance tolerance = tolerance::golden;
  const char* table = "golden/cases.csv";
};

void PrintTo(const GoldenFamily& test, std::ostream* out) { *out << test.name; }

/// The family's cases by number: what to build, from cases.csv.
std::map<std::string, DataTable::Row> cases_of(const DataTable& cases, const std::string& family) {
  std::map<std::string, DataTable::Row> numbered;
  for (const auto& row : cases.rows_where("family", family)) numbered.emplace(row.text("case"), row);
  return numbered;
}

/// A rounding error grows with the ill-conditioning of the case.
MotionTolerance tolerance_of(const MotionTolerance& well_conditioned, const DataTable::Row& golden_case) {
  const double growth = std::max(1.0, 1.0 / (std::numbers::pi - golden_case.number("max_halfangle")));
  return {growth * well_conditioned.orientation, growth * well_conditioned.angular_velocity,
          growth * well_conditioned.angular_acceleration, growth * well_conditioned.angular_jerk};
}

Motion motion_of(const DataTable::Row& row) {
  return {.orientation = row.quaternion("qw", "qx", "qy", "qz"),
          .angular_velocity = row.vector("wx", "wy", "wz"),
          .angular_acceleration = row.vector("ax", "ay", "az"),
          .angular_jerk = row.vector("jx", "jy", "jz")};
}

void expect_agreement(const AnyCurve& curve, const DataTable::Row& row, const MotionTolerance& allowed) {
  const double t = row.number("t");
  const Side side = row.text("side") == "left" ? Side::left : Side::right;
  SCOPED_TRACE("t = " + row.text("t") + " " + row.text("side"));
  ASSERT_EQ(std::to_string(curve.knots().segment_at(t, side)), row.text("segment"));
  EXPECT_TRUE(near(curve.motion(t, side), motion_of(row), allowed));
}

class Golden : public testing::TestWithParam<GoldenFamily> {};

TEST_P(Golden, EveryRowAgreesWithTheReference) {
  const std::string family = GetParam().name;
  const DataTable keys("golden/keys.csv"), all_cases(GetParam().table), rows("golden/" + family + ".csv");
  const auto cases = cases_of(all_cases, family);
  ASSERT_EQ(cases.size(), GetParam().cases);
  ASSERT_EQ(rows.size(), GetParam().rows);

  for (const auto& [number, golden_case] : cases) {
    SCOPED_TRACE(label_of(golden_case));
    const auto curve = make_curve({family, options_of(golden_case)}, keys_of(keys, golden_case));
    ASSERT_TRUE(curve) << describe(curve.error());
    const auto expected = rows.rows_where("case", number);
    ASSERT_FALSE(expected.empty());
    for (const auto& row : expected) expect_agreement(*curve, row, tolerance_of(GetParam().tolerance, golden_case));
  }
}

std::string name_of_test(const testing::TestParamInfo<GoldenFamily>& test) {
  std::string name = test.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
}

// The reference's B-splines weight their control points evenly on every knots; Cox–de Boor agrees where the times are
// even. bspline_test.cpp has the uneven ones.
INSTANTIATE_TEST_SUITE_P(Papers, Golden,
                         testing::Values(GoldenFamily{"slerp", 16, 332}, GoldenFamily{"squad", 32, 664},
                                         GoldenFamily{"quintic", 48, 996}, GoldenFamily{"sextic", 64, 1328},
                                         GoldenFamily{"timed-c1", 68, 1400}, GoldenFamily{"timed-c2", 68, 1400},
                                         GoldenFamily{"timed-c3", 68, 1400}, GoldenFamily{"timed-sextic", 68, 1400},
                                         GoldenFamily{"family", 38, 704}, GoldenFamily{"hermite-cumulative", 21, 428},
                                         GoldenFamily{"bspline", 13, 268}, GoldenFamily{"beta", 34, 432}),
                         name_of_test);

constexpr GoldenFamily wider(const char* name, std::size_t cases, std::size_t rows) {
  return {name, cases, rows, tolerance::golden_wider};
}

INSTANTIATE_TEST_SUITE_P(WiderField, Golden,
                         testing::Values(wider("squad-timed", 19, 352), wider("shoemake", 12, 216),
                                         wider("tcb", 19, 352), wider("barry-goldman", 9, 160),
                                         wider("log-parabola", 19, 352), wider("circular", 19, 352),
                                         wider("nu", 24, 448), wider("nu-exact", 15, 276), wider("global-c2", 15, 276),
                                         wider("rotation-spline", 25, 456), wider("bspline-through", 17, 332),
                                         wider("beta-through", 7, 124), wider("beta-g2", 6, 96)),
                         name_of_test);

constexpr GoldenFamily hermite(const char* name, std::size_t cases, std::size_t rows) {
  return {name, cases, rows, tolerance::golden_hermite};
}

INSTANTIATE_TEST_SUITE_P(ChartHermite, Golden,
                         testing::Values(hermite("hermite-c1", 20, 384), hermite("hermite-c2", 37, 672),
                                         hermite("hermite-c3", 20, 384)),
                         name_of_test);

constexpr GoldenFamily with_table(const char* name, std::size_t cases, std::size_t rows, const char* table) {
  return {name, cases, rows, tolerance::golden_wider, table};
}

INSTANTIATE_TEST_SUITE_P(InR4, Golden,
                         testing::Values(with_table("rational", 29, 604, "golden/rational_cases.csv"),
                                         with_table("biarcs", 16, 292, "golden/biarcs_cases.csv"),
                                         with_table("monotone", 13, 236, "golden/monotone_cases.csv")),
                         name_of_test);

}}  // namespace orispline
