// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/least_squares.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The normal equations of residuals that each involve neighbouring variables only: JᵀJ x = -Jᵀr, in a band.
class BandedSystem {
 public:
  /// Variables further apart than `band` share no residual.
  BandedSystem(std::size_t variables, std::size_t band);

  /// Adds residuals and their Jacobian by the variables of these indices, which increase.
  void add(std::span<const std::size_t> variables, const Eigen::VectorXd& residuals, const Eigen::MatrixXd& jacobian);

  /// The solution by LDLᵀ, in time linear in the number of variables. What the residuals do not determine stays 0, and
  /// so do the variables of `held`. The diagonal is larger by that share of it, as Levenberg and Marquardt have it.
  [[nodiscard]] std::vector<double> solved(std::span<const std::size_t> held = {}, double damping = 0.0) const;

  /// Jᵀr.
  [[nodiscard]] const std::vector<double>& gradient() const noexcept { return gradient_; }

 private:
  [[nodiscard]] double& at(std::vector<double>& matrix, std::size_t row, std::size_t column) const noexcept {
    return matrix[row * (band_ + 1) + (row - column)];
  }

  std::size_t band_;
  std::vector<double> matrix_;  ///< of every row the diagonal and the `band` columns before it
  std::vector<double> gradient_;
};

/// A pivot that is less than this share of its diagonal is rounding.
constexpr double singular = 1e-14;

BandedSystem::BandedSystem(std::size_t variables, std::size_t band)
    : band_(band), matrix_(variables * (band + 1), 0.0), gradient_(variables, 0.0) {}

void BandedSystem::add(std::span<const std::size_t> variables, const Eigen::VectorXd& residuals,
                       const Eigen::MatrixXd& jacobian) {
  for (std::size_t a = 0; a < variables.size(); ++a) {
    const auto column = jacobian.col(static_cast<Eigen::Index>(a));
    gradient_[variables[a]] += column.dot(residuals);
    for (std::size_t b = 0; b <= a; ++b)
      at(matrix_, variables[a], variables[b]) += column.dot(jacobian.col(static_cast<Eigen::Index>(b)));
  }
}

std::vector<double> BandedSystem::solved(std::span<const std::size_t> held, double damping) const {
  std::vector<double> factor = matrix_, x(gradient_.size());
  for (std::size_t i = 0; i < x.size(); ++i) at(factor, i, i) *= 1.0 + damping;
  std::vector<bool> stays(x.size(), false);
  for (const std::size_t variable : held) stays[variable] = true;
  const auto first_of = [this](std::size_t row) { return row > band_ ? row - band_ : 0; };
  for (std::size_t i = 0; i < x.size(); ++i) {
    double pivot = at(factor, i, i), sum = -gradient_[i];
    const double diagonal = pivot;
    for (std::size_t j = first_of(i); j < i; ++j) {
      if (stays[j]) continue;
      double& entry = at(factor, i, j);
      for (std::size_t k = std::max(first_of(i), first_of(j)); k < j; ++k)
        if (!stays[k]) entry -= at(factor, i, k) * at(factor, j, k) * at(factor, k, k);
      const double product = entry;
      entry /= at(factor, j, j);
      pivot -= product * entry;
      sum -= entry * x[j];
    }
    at(factor, i, i) = pivot;
    x[i] = sum;
    stays[i] = stays[i] || !(pivot > singular * diagonal);
  }
  for (std::size_t i = x.size(); i-- > 0;) {
    x[i] = stays[i] ? 0.0 : x[i] / at(factor, i, i);
    for (std::size_t j = i + 1; j < std::min(x.size(), i + band_ + 1); ++j)
      if (!stays[i]) x[i] -= at(factor, j, i) * x[j];
  }
  return x;
}

constexpr double at_rest = 1e-14;  // a step that lowers the sum by a smaller share of it is not made
constexpr double smallest_share = 1e-6;
// Of the diagonal, where a plain step leads up however short it is: along variables that hardly matter it is so long
// that bounds bend it.
constexpr double least_damping = 1e-3, most_damping = 1e12, change_of_damping = 10.0;

BandedSystem normal_equations(const SumOfSquares& sum, std::size_t variables) {
  std::size_t band = 0;
  for (std::size_t block = 0; block < sum.blocks() && !sum.stopped(); ++block)
    if (const auto of_block = sum.variables(block); !of_block.empty())
      band = std::max(band, of_block.back() - of_block.front());
  BandedSystem system(variables, band);
  for (std::size_t block = 0; block < sum.blocks() && !sum.stopped(); ++block)
    if (const auto of_block = sum.variables(block); !of_block.empty())
      system.add(of_block, sum.residuals(block), sum.jacobian(block));
  return system;
}

/// The equations of a step from these values, which are the present state. Variables at a bound that keeps them from
/// going down stay.
class Equations {
 public:
  Equations(const SumOfSquares& sum, std::span<const double> values, std::span<const Interval> bounds)
      : system_(normal_equations(sum, values.size())) {
    for (std::size_t v = 0; v < values.size(); ++v)
      if ((values[v] <= bounds[v].lowest && gradient()[v] > 0.0) ||
          (values[v] >= bounds[v].highest && gradient()[v] < 0.0))
        held_.push_back(v);
  }
  [[nodiscard]] const std::vector<double>& gradient() const noexcept { return system_.gradient(); }
  [[nodiscard]] std::vector<double> step(double damping = 0.0) const { return system_.solved(held_, damping); }
  /// By which a whole step lowers the sum to second order.
  [[nodiscard]] double decrease(const std::vector<double>& step) const {
    double sum = 0.0;
    for (std::size_t v = 0; v < step.size(); ++v) sum -= step[v] * gradient()[v];
    return sum;
  }

 private:
  BandedSystem system_;
  std::vector<std::size_t> held_;
};

/// Where a step begins.
struct Place {
  const std::vector<double>& values;
  double sum;
  std::span<const Interval> bounds;
};

struct LowerPlace {
  std::vector<double> values;
  double sum;
};

/// The end of a step, which is stopped at the bounds and halved until the sum is lower; nothing where only a smaller
/// share of it would do.
std::optional<LowerPlace> lowered(SumOfSquares& sum, const Place& from, const std::vector<double>& step,
                                  double least_share, const OpenEndedWork& work) {
  std::vector<double> next(step.size());
  for (double share = 1.0; share >= least_share && !work.stopped(); share *= 0.5) {
    for (std::size_t v = 0; v < next.size(); ++v)
      next[v] = std::clamp(from.values[v] + share * step[v], from.bounds[v].lowest, from.bounds[v].highest);
    sum.move_to(next);
    if (const double value = value_of(sum); value < from.sum) return LowerPlace{std::move(next), value};
  }
  return std::nullopt;
}

}  // namespace

double value_of(const SumOfSquares& sum) {
  double value = 0.0;
  for (std::size_t block = 0; block < sum.blocks() && !sum.stopped(); ++block)
    value += sum.residuals(block).squaredNorm();
  return value;
}

std::vector<double> newton_step(const SumOfSquares& sum, std::size_t variables, std::span<const std::size_t> held) {
  return normal_equations(sum, variables).solved(held);
}

Descent descent(const SumOfSquares& sum, std::span<const double> values, std::span<const Interval> bounds) {
  const Equations equations(sum, values, bounds);
  std::vector<double> step = equations.step();
  const double decrease = equations.decrease(step);
  return {std::move(step), decrease};
}

Minimum minimised(SumOfSquares& sum, std::vector<double> start, std::span<const Interval> bounds, const SearchEnd& end,
                  OpenEndedWork& work) {
  for (std::size_t v = 0; v < start.size(); ++v) start[v] = std::clamp(start[v], bounds[v].lowest, bounds[v].highest);
  Minimum minimum{std::move(start), 0};
  sum.move_to(minimum.values);
  double damping = 0.0;
  for (double value = value_of(sum); minimum.iterations < end.most_iterations; ++minimum.iterations) {
    if (work.stopped() || value <= end.rounding) break;
    const Equations equations(sum, minimum.values, bounds);
    const std::vector<double> step = equations.step();
    if (!(equations.decrease(step) > at_rest * value)) break;
    const Place place{minimum.values, value, bounds};
    auto lower = damping > 0.0 ? std::nullopt : lowered(sum, place, step, smallest_share, work);
    while (!lower && damping < most_damping && !work.stopped()) {
      damping = std::max(least_damping, change_of_damping * damping);
      lower = lowered(sum, place, equations.step(damping), 1.0, work);
    }
    if (!lower) break;
    damping = damping > change_of_damping * least_damping ? damping / (change_of_damping * change_of_damping) : 0.0;
    value = lower->sum;
    minimum.values = std::move(lower->values);
    work.add(1.0);
  }
  sum.move_to(minimum.values);
  return minimum;
}

}}  // namespace orispline
