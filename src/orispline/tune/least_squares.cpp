// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/least_squares.hpp>

#include <algorithm>

#include <orispline/tune/banded_system.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr double at_rest = 1e-14;  // a step that lowers the sum by a smaller share of it is not made
constexpr double smallest_share = 1e-6;

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
  const BandedSystem system = normal_equations(sum, values.size());
  std::vector<std::size_t> held;
  for (std::size_t v = 0; v < values.size(); ++v)
    if ((values[v] <= bounds[v].lowest && system.gradient()[v] > 0.0) ||
        (values[v] >= bounds[v].highest && system.gradient()[v] < 0.0))
      held.push_back(v);
  Descent found{system.solved(held), 0.0};
  for (std::size_t v = 0; v < values.size(); ++v) found.decrease -= found.step[v] * system.gradient()[v];
  return found;
}

Minimum minimised(SumOfSquares& sum, std::vector<double> start, std::span<const Interval> bounds, const SearchEnd& end,
                  OpenEndedWork& work) {
  for (std::size_t v = 0; v < start.size(); ++v) start[v] = std::clamp(start[v], bounds[v].lowest, bounds[v].highest);
  Minimum minimum{std::move(start), 0};
  sum.move_to(minimum.values);
  for (double value = value_of(sum); minimum.iterations < end.most_iterations; ++minimum.iterations) {
    if (work.stopped() || value <= end.rounding) break;
    const Descent found = descent(sum, minimum.values, bounds);
    if (!(found.decrease > at_rest * value)) break;
    double lower = value;
    std::vector<double> next;
    for (double share = 1.0; share > smallest_share && !(lower < value) && !work.stopped(); share *= 0.5) {
      next = minimum.values;
      for (std::size_t v = 0; v < next.size(); ++v)
        next[v] = std::clamp(next[v] + share * found.step[v], bounds[v].lowest, bounds[v].highest);
      sum.move_to(next);
      lower = value_of(sum);
    }
    if (!(lower < value)) break;
    value = lower;
    minimum.values = std::move(next);
    work.add(1.0);
  }
  sum.move_to(minimum.values);
  return minimum;
}

}  // namespace orispline::inline ORISPLINE_ABI
