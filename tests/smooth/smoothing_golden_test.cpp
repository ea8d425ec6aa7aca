// SPDX-License-Identifier: Apache-2.0
// Smoothing against the minimisers of the reference: tests/data/golden/smooth_*.csv, made by
// tools/make_golden.py smooth; and smoothing splines of positions against exact ones: position_splines.csv, made by
// tools/make_golden.py positions, which agrees on the cubic ones with SciPy's make_smoothing_spline to 3e-11.
#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_trace.hpp>
#include <support/near.hpp>

#include "smooth/smoothing_case.hpp"

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::golden_figure;
using testing_support::relative_error;
using testing_support::SmoothingCase;

constexpr SmoothingIteration to_the_end{.tolerance = 1e-12, .most = 200};

std::vector<SmoothingCase> cases() {
  static const DataTable table("golden/smooth_cases.csv"), nodes("golden/smooth_nodes.csv");
  std::vector<SmoothingCase> all;
  for (const auto& row : table.rows()) all.emplace_back(nodes, row);
  return all;
}

void expect_figure(double found, const DataTable::Row& row, const char* column) {
  EXPECT_NEAR(found, row.number(column), golden_figure * std::abs(row.number(column))) << column;
}

TEST(SmoothingGolden, NodesAreThoseOfTheReference) {
  ASSERT_EQ(cases().size(), 6u);
  for (const auto& test : cases()) {
    SCOPED_TRACE(test.row.text("name"));
    const auto fit = test.fitted(to_the_end);
    for (std::size_t i = 0; i < test.nodes.size(); ++i) {
      const auto& node = test.nodes[i];
      const auto wanted = node.quaternion("found_qw", "found_qx", "found_qy", "found_qz");
      EXPECT_LT(angular_distance(fit.nodes.orientations[i], wanted), golden_figure) << i;
      EXPECT_LT(relative_error(fit.nodes.angular_velocities[i], node.vector("wx", "wy", "wz")), golden_figure) << i;
      EXPECT_LT(relative_error(fit.nodes.angular_accelerations[i], node.vector("ax", "ay", "az")), 10 * golden_figure)
          << i;
    }
    EXPECT_LT(relative_error(fit.nodes.gyro_correction, test.row.vector("bx", "by", "bz")), golden_figure);
  }
}

TEST(SmoothingGolden, FiguresAreThoseOfTheReference) {
  for (const auto& test : cases()) {
    SCOPED_TRACE(test.row.text("name"));
    const auto fit = test.fitted(to_the_end);
    expect_figure(fit.cost, test.row, "cost");
    expect_figure(fit.data, test.row, "data");
    expect_figure(fit.penalty, test.row, "penalty");
    const auto& problem = test.problem;
    expect_figure(log_determinant(problem, test.objective, fit.nodes), test.row, "log_determinant");
    expect_figure(hat_trace({problem.times, problem.weights, test.objective.penalty, test.objective.lambda}), test.row,
                  "trace");
  }
}

TEST(SmoothingGolden, PositionsAreThoseOfExactSplines) {
  const DataTable table("golden/position_splines.csv");
  for (const char* const number : {"0", "1", "2", "3", "4", "5"}) {
    SCOPED_TRACE(number);
    const auto rows = table.rows_where("case", number);
    ASSERT_GE(rows.size(), 18u);
    SmoothingProblem problem;
    for (const auto& row : rows) {
      problem.times.push_back(row.number("t"));
      problem.positions.push_back(row.vector("px", "py", "pz"));
      problem.weights.push_back(row.number("weight"));
    }
    const Penalty penalty = rows[0].text("order") == "2" ? Penalty::acceleration : Penalty::jerk;
    const double lambda = rows[0].number("lambda");
    const auto fit = fit_smoothing(problem, {.penalty = penalty, .lambda = lambda});
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_LT(relative_error(fit.nodes.positions[i], rows[i].vector("found_px", "found_py", "found_pz")),
                golden_figure)
          << i;
    expect_figure(fit.penalty, rows[0], "penalty");
    EXPECT_NEAR(fit.cost, fit.data + lambda * fit.penalty, 1e-12 * fit.cost);
    expect_figure(hat_trace({problem.times, problem.weights, penalty, lambda}), rows[0], "trace");
  }
}

}}  // namespace orispline
