// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/chain_jacobian.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI { namespace chain {

namespace {

/// Unknowns of one colour share no equation: one pass over duals differentiates by all of three colours at once.
std::vector<std::size_t> colours(std::size_t size, bool closed) {
  std::vector<std::size_t> colour(size);
  for (std::size_t i = 0; i < size; ++i) colour[i] = i % 3;
  const std::size_t beyond = closed ? size % 3 : 0;  // where the row of three does not close
  for (std::size_t k = 0; k < beyond; ++k) colour[size - 1 - k] = 3 + k;
  return colour;
}

/// The equations that unknown i enters.
std::vector<std::size_t> touched(std::size_t size, bool closed, std::size_t i) {
  std::vector<std::size_t> all{i};
  if (i > 0 || closed) all.push_back((i + size - 1) % size);
  if (i + 1 < size || closed) all.push_back((i + 1) % size);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

void differentiate(std::size_t size, bool closed, const std::function<DualSteps(const DualSteps&)>& residual,
                   const TakeBlock& take) {
  const std::vector<std::size_t> colour = colours(size, closed);
  for (std::size_t first = 0; first <= *std::ranges::max_element(colour); first += 3) {
    const auto in_pass = [&](std::size_t i) { return first <= colour[i] && colour[i] < first + 3; };
    DualSteps steps(size, Vector3<Dual9>::Constant(0.0));
    for (std::size_t i = 0; i < size; ++i)
      if (in_pass(i)) steps[i] = variables<9>(Eigen::Vector3d::Zero(), 3 * (colour[i] - first));
    const DualSteps values = residual(steps);
    for (std::size_t i = 0; i < size; ++i)
      if (in_pass(i))
        for (const std::size_t row : touched(size, closed, i))
          take(row, i, derivatives(values[row], 3 * (colour[i] - first)));
  }
}

}}}  // namespace orispline::chain
