// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/quadrature.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Nodes = Eigen::Array<double, gauss_nodes, 1>;  // in [0, 1], or what there is of each

struct GaussRule {
  Nodes u, weights;
};
GaussRule gauss_rule() {
  GaussRule rule;
  const auto nodes = gauss_legendre<gauss_nodes>();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    rule.u[at] = nodes[i].u;
    rule.weights[at] = nodes[i].weight;
  }
  return rule;
}

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

/// The weights of values at nodes that lie beside those of a rule: what the rule makes of Lagrange's polynomials there.
Nodes weights_beside(const GaussRule& rule, const Nodes& u) {
  std::array<Nodes, gauss_nodes> before;  // products of the rule's distances from the nodes before each
  Nodes product = rule.weights, across = Nodes::Ones();
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    before[static_cast<std::size_t>(i)] = product;
    product *= rule.u - u[i];
    Nodes others = u - u[i];
    others[i] = 1.0;
    across *= others;
  }
  Nodes weights;
  product.setOnes();
  for (Eigen::Index i = u.size(); i-- > 0;) {
    weights[i] = (before[static_cast<std::size_t>(i)] * product).sum();
    product *= rule.u - u[i];
  }
  return weights / across;
}

}  // namespace

TimeRule time_rule(double a, double b) noexcept {
  static const GaussRule gauss = gauss_rule();
  TimeRule rule;
  Eigen::Map<Nodes> times(rule.times.data()), weights(rule.weights.data());
  times = a + gauss.u * (b - a);
  weights = gauss.weights;
  const Nodes u = (times - a) / (b - a);
  if ((u - gauss.u).abs().maxCoeff() > same_nodes && is_long_enough(a, b)) weights = weights_beside(gauss, u);
  return rule;
}

double quadrature_tolerance(double a, double b) noexcept {
  return std::max(smooth_tolerance, share_beyond * rounding_of_times(a, b) / (b - a));
}

bool can_be_halved(double a, double b) noexcept { return is_long_enough(a, 0.5 * (a + b)); }

}}  // namespace orispline
