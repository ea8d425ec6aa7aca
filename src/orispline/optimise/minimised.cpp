// SPDX-License-Identifier: Apache-2.0
// The only source that knows Ceres.
#include <orispline/optimise/least_squares.hpp>

#include <algorithm>
#include <cmath>
#include <thread>

#include <ceres/ceres.h>

namespace orispline::optimise {
namespace {

constexpr int most_iterations = 500;
/// The sum has come to rest when a step changes it by less than this share: the variables are then right to 1e-7.
constexpr double rest = 1e-15;

/// A block of the sum, at the state that `State` has brought it to.
class Block final : public ceres::CostFunction {
 public:
  Block(const SumOfSquares& sum, std::size_t block) : sum_(sum), block_(block) {
    set_num_residuals(static_cast<int>(sum.residual_count(block)));
    mutable_parameter_block_sizes()->assign(sum.variables(block).size(), 1);
  }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    const Eigen::VectorXd values = sum_.residuals(block_);
    if (!values.allFinite()) return false;
    std::copy(values.begin(), values.end(), residuals);
    if (!jacobians) return true;
    const Eigen::MatrixXd slopes = sum_.jacobian(block_);
    for (Eigen::Index v = 0; v < slopes.cols(); ++v)
      if (double* column = jacobians[v]) Eigen::Map<Eigen::VectorXd>(column, slopes.rows()) = slopes.col(v);
    return slopes.allFinite();
  }

 private:
  const SumOfSquares& sum_;
  std::size_t block_;
};

/// Moves the sum to the values that Ceres tries next.
class State final : public ceres::EvaluationCallback {
 public:
  State(SumOfSquares& sum, const std::vector<double>& values) : sum_(sum), values_(values) {}
  void PrepareForEvaluation(bool, bool new_point) override {
    if (new_point) sum_.move_to(values_);
  }

 private:
  SumOfSquares& sum_;
  const std::vector<double>& values_;
};

ceres::Solver::Options solver_options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = most_iterations;
  options.num_threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  options.function_tolerance = rest;
  options.gradient_tolerance = 0.0;
  options.parameter_tolerance = 0.0;
  options.max_num_consecutive_invalid_steps = 50;  // of curves that cannot be made
  options.initial_trust_region_radius = 1e8;       // the start is near
  return options;
}

}  // namespace

Minimum minimised(SumOfSquares& sum, std::vector<double> start, std::span<const Interval> bounds) {
  for (std::size_t v = 0; v < start.size(); ++v) start[v] = std::clamp(start[v], bounds[v].lowest, bounds[v].highest);
  State state(sum, start);
  ceres::Problem::Options options;
  options.evaluation_callback = &state;
  ceres::Problem problem(options);
  for (std::size_t block = 0; block < sum.blocks(); ++block) {
    std::vector<double*> parameters;
    for (const std::size_t v : sum.variables(block)) parameters.push_back(&start[v]);
    if (!parameters.empty() && sum.residual_count(block) > 0)
      problem.AddResidualBlock(new Block(sum, block), nullptr, parameters);
  }
  for (std::size_t v = 0; v < start.size(); ++v) {
    if (!problem.HasParameterBlock(&start[v])) continue;
    if (std::isfinite(bounds[v].lowest)) problem.SetParameterLowerBound(&start[v], 0, bounds[v].lowest);
    if (std::isfinite(bounds[v].highest)) problem.SetParameterUpperBound(&start[v], 0, bounds[v].highest);
  }
  ceres::Solver::Summary summary;
  if (problem.NumResidualBlocks() > 0) ceres::Solve(solver_options(), &problem, &summary);
  return {std::move(start), static_cast<std::size_t>(std::max(0, summary.num_successful_steps))};
}

}  // namespace orispline::optimise
