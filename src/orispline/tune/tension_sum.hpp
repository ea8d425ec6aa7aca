// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include <orispline/tune/least_squares.hpp>
#include <orispline/tune/segment_residuals.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// An objective as a function of the tensions of a model: one block per segment.
class TensionSum final : public SumOfSquares {
 public:
  TensionSum(const TensionModel& model, const Goal& goal, const OpenEndedWork* work = nullptr)
      : SumOfSquares(work), model_(model), goal_(goal) {
    for (const Variable& variable : model.variables) values_.push_back(variable.initial);
  }

  void move_to(const std::vector<double>& values) override { values_ = values; }
  [[nodiscard]] std::size_t blocks() const noexcept override { return model_.segments.size(); }
  [[nodiscard]] std::span<const std::size_t> variables(std::size_t block) const override {
    return model_.segments[block].variables;
  }
  [[nodiscard]] std::size_t residual_count(std::size_t block) const override {
    return orispline::residual_count(goal_, block);
  }
  [[nodiscard]] Eigen::VectorXd residuals(std::size_t block) const override {
    return residual_values(model_.segments[block], goal_, block, values_of(block));
  }
  [[nodiscard]] Eigen::MatrixXd jacobian(std::size_t block) const override {
    return residual_jacobian(model_.segments[block], goal_, block, values_of(block));
  }

 private:
  [[nodiscard]] std::vector<double> values_of(std::size_t block) const {
    std::vector<double> values;
    for (const std::size_t v : model_.segments[block].variables) values.push_back(values_[v]);
    return values;
  }

  const TensionModel& model_;
  const Goal& goal_;
  std::vector<double> values_;
};

}}  // namespace orispline
