// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/smooth/smoothing.hpp>
#include <support/data_table.hpp>

namespace orispline::testing_support {

/// Relative, of what the reference gives for a case.
inline constexpr double golden_figure = 1e-9;

/// A case of golden/smooth_cases.csv with its nodes.
struct SmoothingCase {
  DataTable::Row row;
  orispline::SmoothingProblem problem{};
  orispline::SmoothingObjective objective{};
  std::vector<DataTable::Row> nodes{};

  SmoothingCase(const DataTable& node_table, const DataTable::Row& case_row)
      : row(case_row), nodes(node_table.rows_where("case", case_row.text("case"))) {
    const bool gyro = nodes.front().number("gyro_weight") > 0.0;
    for (const auto& node : nodes) {
      problem.times.push_back(node.number("t"));
      problem.orientations.push_back(node.quaternion("qw", "qx", "qy", "qz"));
      problem.weights.push_back(node.number("weight"));
      if (gyro) problem.gyro.push_back(node.vector("gx", "gy", "gz"));
      if (gyro) problem.gyro_weights.push_back(node.number("gyro_weight"));
    }
    objective = {.penalty = row.text("order") == "2" ? Penalty::acceleration : Penalty::jerk,
                 .lambda = row.number("lambda"),
                 .loss = row.text("loss") == "tukey" ? LossFunction::tukey : LossFunction::l2,
                 .threshold = row.number("threshold"),
                 .bias = row.text("bias") == "1" ? SmoothingObjective::Bias::constant : SmoothingObjective::Bias::none};
  }

  [[nodiscard]] orispline::SmoothingFit fitted(const orispline::SmoothingIteration& iteration) const {
    if (row.text("start") == "data") return fit_smoothing(problem, objective, iteration);
    orispline::SmoothingObjective first = objective;
    first.loss = orispline::LossFunction::huber;
    const auto start = fit_smoothing(problem, first, iteration);
    return fit_smoothing(problem, objective, iteration, &start.nodes);
  }
};

}  // namespace orispline::testing_support
