// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <utility>

#include <orispline/tune/construction.hpp>
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

/// An objective as a function of what a construction varies: one block per segment.
class ConstructionSum final : public SumOfSquares {
 public:
  ConstructionSum(const ConstructionModel& model, const Goal& goal, const OpenEndedWork* work = nullptr)
      : SumOfSquares(work), model_(model), goal_(goal), work_(work) {
    std::vector<double> values;
    for (const Variable& variable : model.model.variables) values.push_back(variable.initial);
    curve_ = model_.construction->at(model_.model.with(values), work_);
  }

  void move_to(const std::vector<double>& values) override {
    curve_ = model_.construction->at(model_.model.with(values), work_);
  }
  [[nodiscard]] std::size_t blocks() const noexcept override { return model_.construction->variables().size(); }
  [[nodiscard]] std::span<const std::size_t> variables(std::size_t block) const override {
    return model_.construction->variables()[block];
  }
  [[nodiscard]] std::size_t residual_count(std::size_t block) const override {
    return orispline::residual_count(goal_, block);
  }
  [[nodiscard]] Eigen::VectorXd residuals(std::size_t block) const override {
    if (curve_) return residual_values(curve_->segments[block], goal_, block, {});
    return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(residual_count(block)),
                                     std::numeric_limits<double>::quiet_NaN());
  }
  [[nodiscard]] Eigen::MatrixXd jacobian(std::size_t block) const override {
    return residual_jacobian(curve_->segments[block], goal_, block, curve_->slopes[block]);
  }

 private:
  const ConstructionModel& model_;
  const Goal& goal_;
  const OpenEndedWork* work_;
  std::optional<ConstructedCurve> curve_;
};

}}  // namespace orispline
