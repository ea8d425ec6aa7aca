// SPDX-License-Identifier: Apache-2.0
// Every family against 60-digit values: tests/data/golden, made by tools/make_golden.py.
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline {
namespace {

using testing_support::DataTable;
using testing_support::relative_error;

struct GoldenFamily {
  const char* name;
  std::size_t cases, rows;  ///< as many as the reference has: none may get lost on the way
};

void PrintTo(const GoldenFamily& test, std::ostream* out) { *out << test.name; }

Eigen::Vector3d end_rate(const DataTable::Row& row, std::string_view column) {
  const auto values = row.numbers(column);
  return values.empty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(values.at(0), values.at(1), values.at(2));
}

Keyframes keys_of(const DataTable& keys, const DataTable::Row& row) {
  KeyframeData data;
  const std::vector<double> rates = row.numbers("key_rates");
  for (std::size_t i = 0; i < rates.size(); i += 3)
    data.angular_velocities.emplace_back(rates.at(i), rates.at(i + 1), rates.at(i + 2));
  for (const auto& key : keys.rows_where("sequence", row.text("sequence"))) {
    data.times.push_back(key.number("t"));
    data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
  }
  return Keyframes::make(std::move(data), row.text("signs") == "as_given" ? Signs::as_given : Signs::shortest).value();
}

/// `name=value value…;name=…`
std::map<std::string, std::vector<double>, std::less<>> parameters_of(const std::string& text) {
  std::map<std::string, std::vector<double>, std::less<>> parameters;
  if (text.empty()) return parameters;
  for (const std::string& parameter : testing_support::fields_of(text, ';')) {
    const auto parts = testing_support::fields_of(parameter, '=');
    for (const std::string& value : testing_support::fields_of(parts.at(1), ' '))
      parameters[parts[0]].push_back(testing_support::number_of(value));
  }
  return parameters;
}

CurveOptions options_of(const DataTable::Row& row) {
  CurveOptions options{.parameters = parameters_of(row.text("parameters"))};
  if (!row.text("period").empty()) options.loop = Loop{.period = row.number("period")};
  if (!row.text("ends").empty()) {
    const EndRule rule = end_rule_by_name(*find_family(row.text("family")).value(), row.text("ends")).value();
    options.start = {.rule = rule, .angular_velocity = end_rate(row, "start_rate")};
    options.end = {.rule = rule, .angular_velocity = end_rate(row, "end_rate")};
  }
  return options;
}

struct GoldenCase {
  AnyCurve curve;
  double ill_conditioning;  ///< how much a rounding error grows: at least 1
  std::string label;
};

std::map<std::string, GoldenCase> golden_cases(const std::string& family) {
  const DataTable keys("golden/keys.csv"), cases("golden/cases.csv");
  std::map<std::string, GoldenCase> built;
  for (const auto& row : cases.rows_where("family", family)) {
    const double distance_to_pi = std::numbers::pi - row.number("max_halfangle");
    built.emplace(row.text("case"), GoldenCase{make_curve(family, keys_of(keys, row), options_of(row)).value(),
                                               std::max(1.0, 1.0 / distance_to_pi),
                                               row.text("sequence") + ", " + row.text("signs") + " signs, ends '" +
                                                   row.text("ends") + "', parameters " + row.text("parameters")});
  }
  return built;
}

class Golden : public testing::TestWithParam<GoldenFamily> {};

TEST_P(Golden, EveryRowAgreesWithTheReference) {
  const auto cases = golden_cases(GetParam().name);
  const DataTable rows(std::string("golden/") + GetParam().name + ".csv");
  ASSERT_EQ(cases.size(), GetParam().cases);
  ASSERT_EQ(rows.size(), GetParam().rows);

  for (const auto& row : rows.rows()) {
    const GoldenCase& golden = cases.at(row.text("case"));
    const double t = row.number("t"), growth = golden.ill_conditioning;
    SCOPED_TRACE(golden.label + ", t = " + row.text("t") + " " + row.text("side"));
    const Side side = row.text("side") == "left" ? Side::left : Side::right;
    ASSERT_EQ(std::to_string(golden.curve.knots().segment_at(t, side)), row.text("segment"));

    const Motion m = golden.curve.motion(t, side);

    EXPECT_LE(relative_error(m.orientation, row.quaternion("qw", "qx", "qy", "qz")),
              growth * tolerance::golden::orientation);
    EXPECT_LE(relative_error(m.angular_velocity, row.vector("wx", "wy", "wz")),
              growth * tolerance::golden::angular_velocity);
    EXPECT_LE(relative_error(m.angular_acceleration, row.vector("ax", "ay", "az")),
              growth * tolerance::golden::angular_acceleration);
    EXPECT_LE(relative_error(m.angular_jerk, row.vector("jx", "jy", "jz")), growth * tolerance::golden::angular_jerk);
  }
}

// The reference's approximating B-spline weights its control points evenly on every knots; Cox–de Boor agrees where the
// times are even. bspline_test.cpp has the uneven ones.
INSTANTIATE_TEST_SUITE_P(Reference, Golden,
                         testing::Values(GoldenFamily{"slerp", 16, 332}, GoldenFamily{"squad", 32, 664},
                                         GoldenFamily{"squad-timed", 14, 256}, GoldenFamily{"quintic", 48, 996},
                                         GoldenFamily{"sextic", 64, 1328}, GoldenFamily{"timed-c1", 68, 1400},
                                         GoldenFamily{"timed-c2", 68, 1400}, GoldenFamily{"timed-c3", 68, 1400},
                                         GoldenFamily{"timed-sextic", 68, 1400}, GoldenFamily{"family", 38, 704},
                                         GoldenFamily{"hermite-cumulative", 21, 428}, GoldenFamily{"bspline", 13, 268},
                                         GoldenFamily{"beta", 34, 432}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace orispline
