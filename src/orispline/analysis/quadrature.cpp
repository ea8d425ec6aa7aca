// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/quadrature.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Nodes = std::array<double, gauss_nodes>;  // in [0, 1]

/// Nodes nearer than this to those of the rule have its weights: their sums differ by rounding.
constexpr double same_nodes = 1e-13;
constexpr double smooth_tolerance = 1e-10;
/// Where the weights are others, this share of the integrand, beyond degree 9, is summed with an error like the nodes'.
constexpr double share_beyond = 0.01;
/// So many roundings of its times is a piece long whose nodes, the first of them 1/77 from its end, are all distinct.
constexpr double shortest_piece = 256.0;

double rounding_of_times(double a, double b) {
  return std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

bool is_long_enough(double a, double b) { return b - a >= shortest_piece * rounding_of_times(a, b); }

/// Barycentric weights of the polynomial through values at the nodes (Berrut & Trefethen 2004).
Nodes barycentric(const Nodes& u) {
  Nodes weights;
  for (std::size_t i = 0; i < u.size(); ++i) {
    double product = 1.0;
    for (std::size_t j = 0; j < u.size(); ++j)
      if (j != i) product *= u[i] - u[j];
    weights[i] = 1.0 / product;
  }
  return weights;
}

/// The weights of values at nodes that lie beside those of a rule: what the rule makes of the polynomial through them.
Nodes weights_beside(const std::array<QuadratureNode, gauss_nodes>& rule, const Nodes& u) {
  const Nodes through = barycentric(u);
  Nodes weights{};
  for (std::size_t m = 0; m < rule.size(); ++m) {
    if (rule[m].u == u[m]) {
      weights[m] += rule[m].weight;
      continue;
    }
    Nodes shares;
    double sum = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += shares[i] = through[i] / (rule[m].u - u[i]);
    for (std::size_t i = 0; i < u.size(); ++i) weights[i] += rule[m].weight * shares[i] / sum;
  }
  return weights;
}

}  // namespace

TimeRule time_rule(double a, double b) noexcept {
  static const auto gauss = gauss_legendre<gauss_nodes>();
  TimeRule rule;
  Nodes u;
  double moved = 0.0;
  for (std::size_t i = 0; i < gauss_nodes; ++i) {
    rule.times[i] = std::lerp(a, b, gauss[i].u);
    rule.weights[i] = gauss[i].weight;
    u[i] = (rule.times[i] - a) / (b - a);
    moved = std::max(moved, std::abs(u[i] - gauss[i].u));
  }
  if (moved > same_nodes && is_long_enough(a, b)) rule.weights = weights_beside(gauss, u);
  return rule;
}

double quadrature_tolerance(double a, double b) noexcept {
  return std::max(smooth_tolerance, share_beyond * rounding_of_times(a, b) / (b - a));
}

bool can_be_halved(double a, double b) noexcept { return is_long_enough(a, 0.5 * (a + b)); }

}}  // namespace orispline
