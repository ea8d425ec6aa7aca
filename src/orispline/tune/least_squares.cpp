// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/least_squares.hpp>

#include <algorithm>
#include <optional>

#include <orispline/tune/banded_system.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

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
