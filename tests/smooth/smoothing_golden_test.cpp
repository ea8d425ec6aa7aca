// SPDX-License-Identifier: Apache-2.0
// Smoothing against the minimisers of the reference: tests/data/golden/smooth_*.csv, made by
// tools/make_smooth_golden.py.
#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_trace.hpp>
#include <support/near.hpp>

#include "smooth/smoothing_case.hpp"

namespace orispline {
namespace {

using testing_support::DataTable;
using testing_support::relative_error;
using testing_support::SmoothingCase;

constexpr double golden = 1e-9;
constexpr SmoothingIteration to_the_end{.tolerance = 1e-12, .most = 200};

std::vector<SmoothingCase> cases() {
  static const DataTable table("golden/smooth_cases.csv"), nodes("golden/smooth_nodes.csv");
  std::vector<SmoothingCase> all;
  for (const auto& row : table.rows()) all.emplace_back(nodes, row);
  return all;
}

void expect_figure(double found, const DataTable::Row& row, const char* column) {
  EXPECT_NEAR(found, row.number(column), golden * std::abs(row.number(column))) << column;
}

TEST(SmoothingGolden, NodesAreThoseOfTheReference) {
  ASSERT_EQ(cases().size(), 6u);
  for (const auto& test : cases()) {
    SCOPED_TRACE(test.row.text("name"));
    const auto fit = test.fitted(to_the_end);
    for (std::size_t i = 0; i < test.nodes.size(); ++i) {
      const auto& node = test.nodes[i];
      const auto wanted = node.quaternion("found_qw", "found_qx", "found_qy", "found_qz");
      EXPECT_LT(angular_distance(fit.nodes.orientations[i], wanted), golden) << i;
      EXPECT_LT(relative_error(fit.nodes.angular_velocities[i], node.vector("wx", "wy", "wz")), golden) << i;
      EXPECT_LT(relative_error(fit.nodes.angular_accelerations[i], node.vector("ax", "ay", "az")), 10 * golden) << i;
    }
    EXPECT_LT(relative_error(fit.nodes.gyro_correction, test.row.vector("bx", "by", "bz")), golden);
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
    expect_figure(hat_trace(problem.times, problem.weights, test.objective.penalty, test.objective.lambda), test.row,
                  "trace");
  }
}

}  // namespace
}  // namespace orispline
