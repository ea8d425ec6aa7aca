// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <orispline/base/interval.hpp>
#include <orispline/base/progress.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A sum of squares that falls into blocks, each of which depends on few variables near to each other.
class SumOfSquares {
 public:
  explicit SumOfSquares(const OpenEndedWork* work = nullptr) : work_(work) {}
  virtual ~SumOfSquares() = default;
  /// Whether the work that the sum is for is stopped. What is made of the sum from then on is of a part of it.
  [[nodiscard]] bool stopped() const noexcept { return work_ && work_->stopped(); }
  /// Brings the state to these values. Where there is none, as for equations without a solution, residuals are NaN.
  virtual void move_to(const std::vector<double>& values) = 0;
  [[nodiscard]] virtual std::size_t blocks() const noexcept = 0;
  /// The variables of a block, which increase.
  [[nodiscard]] virtual std::span<const std::size_t> variables(std::size_t block) const = 0;
  [[nodiscard]] virtual std::size_t residual_count(std::size_t block) const = 0;
  /// At the present state.
  [[nodiscard]] virtual Eigen::VectorXd residuals(std::size_t block) const = 0;
  [[nodiscard]] virtual Eigen::MatrixXd jacobian(std::size_t block) const = 0;

 private:
  const OpenEndedWork* work_;
};

/// The sum at the present state.
[[nodiscard]] double value_of(const SumOfSquares& sum);

/// One Gauss–Newton step from the present state: to the minimum itself where the residuals are affine. Linear time.
[[nodiscard]] std::vector<double> newton_step(const SumOfSquares& sum, std::size_t variables,
                                              std::span<const std::size_t> held = {});

/// A Gauss–Newton step, and by how much it lowers the sum to second order. Variables at a bound that keeps them from
/// going down stay.
struct Descent {
  std::vector<double> step;
  double decrease;
};
/// From these values, which are the present state.
[[nodiscard]] Descent descent(const SumOfSquares& sum, std::span<const double> values,
                              std::span<const Interval> bounds);

/// When a search for the least sum ends.
struct SearchEnd {
  std::size_t most_iterations;
  double rounding = 0.0;  ///< a sum that is no larger is rounding altogether, and at rest
};

/// Where the sum has its least value near the start, and how many steps led there.
struct Minimum {
  std::vector<double> values;
  std::size_t iterations;
};

/// Gauss–Newton steps with exact derivatives from the start, which is brought within the bounds, each halved until the
/// sum is lower and stopped at the bounds, until the sum is at rest. Moves the sum there. Every step is a piece of the
/// work; ends early where that is stopped.
[[nodiscard]] Minimum minimised(SumOfSquares& sum, std::vector<double> start, std::span<const Interval> bounds,
                                const SearchEnd& end, OpenEndedWork& work);

}}  // namespace orispline
