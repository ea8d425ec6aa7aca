// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/least_squares.hpp>

#include <algorithm>

#include <orispline/optimise/banded_system.hpp>

namespace orispline::optimise {
namespace {

BandedSystem normal_equations(const SumOfSquares& sum, std::size_t variables) {
  std::size_t band = 0;
  for (std::size_t block = 0; block < sum.blocks(); ++block)
    if (const auto of_block = sum.variables(block); !of_block.empty())
      band = std::max(band, of_block.back() - of_block.front());
  BandedSystem system(variables, band);
  for (std::size_t block = 0; block < sum.blocks(); ++block)
    if (const auto of_block = sum.variables(block); !of_block.empty())
      system.add(of_block, sum.residuals(block), sum.jacobian(block));
  return system;
}

}  // namespace

double value_of(const SumOfSquares& sum) {
  double value = 0.0;
  for (std::size_t block = 0; block < sum.blocks(); ++block) value += sum.residuals(block).squaredNorm();
  return value;
}

std::vector<double> newton_step(const SumOfSquares& sum, std::size_t variables, std::span<const std::size_t> held) {
  return normal_equations(sum, variables).solved(held);
}

double stationarity(const SumOfSquares& sum, std::span<const double> values, std::span<const Interval> bounds) {
  const double value = value_of(sum);
  if (!(value > 0.0)) return 0.0;
  const BandedSystem system = normal_equations(sum, values.size());
  std::vector<std::size_t> held;
  for (std::size_t v = 0; v < values.size(); ++v)
    if ((values[v] <= bounds[v].lowest && system.gradient()[v] > 0.0) ||
        (values[v] >= bounds[v].highest && system.gradient()[v] < 0.0))
      held.push_back(v);
  const std::vector<double> step = system.solved(held);
  double decrease = 0.0;
  for (std::size_t v = 0; v < step.size(); ++v) decrease -= step[v] * system.gradient()[v];
  return decrease / value;
}

}  // namespace orispline::optimise
