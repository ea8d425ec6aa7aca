// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/quadrature.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/math/gauss_legendre.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Nodes nearer than this to those of the rule have its weights: their sums differ by rounding.
constexpr double same_nodes = 1e-13;
/// Nodes nearer than this have weights that are linear in the distance, to rounding.
constexpr double near_nodes = 1e-9;
constexpr double smooth_tolerance = 1e-10;
/// Where the weights are others, Gauss's rule sums this share of the integrand, beyond degree 9, with an error like the
/// nodes'.
constexpr double share_beyond = 0.01;
/// So many roundings of its times is a piece long whose nodes, two of them 1/92 of it apart, are all distinct.
constexpr double shortest_piece = 256.0;

/// A rule on [0, 1] that takes the polynomial through the values at its nodes.
template <int N>
class Rule {
 public:
  using Nodes = Eigen::Array<double, N, 1>;  // or what there is of each

  Rule(const Nodes& nodes, const Nodes& weights) : nodes_(nodes), weights_(weights) {
    for (Eigen::Index j = 0; j < N; ++j)
      for (Eigen::Index i = 0; i < N; ++i) slopes_(i, j) = static_cast<float>(-weights_[j] * slope_at(j, i));
  }

  [[nodiscard]] const Nodes& nodes() const noexcept { return nodes_; }

  /// The weights of values at nodes that lie beside the rule's.
  [[nodiscard]] Nodes weights_at(const Nodes& u) const noexcept {
    const Nodes moved = u - nodes_;
    const double farthest = moved.abs().maxCoeff();
    if (!(farthest > same_nodes)) return weights_;
    if (farthest > near_nodes) return weights_beside(u);
    Slopes change = Slopes::Zero();
    for (Eigen::Index j = 0; j < N; ++j) change += static_cast<float>(moved[j]) * slopes_.col(j);
    return weights_ + change.template cast<double>();
  }

 private:
  using Slopes = Eigen::Array<float, N, 1>;

  /// The slope of Lagrange's polynomial i at node j.
  [[nodiscard]] double slope_at(Eigen::Index j, Eigen::Index i) const noexcept {
    const Nodes here = distances_from(j);
    return i == j ? here.inverse().sum() - 1.0 : here.prod() / (distances_from(i).prod() * here[i]);
  }
  /// Those from node i, and 1 in the place of its own.
  [[nodiscard]] Nodes distances_from(Eigen::Index i) const noexcept {
    Nodes distances = nodes_[i] - nodes_;
    distances[i] = 1.0;
    return distances;
  }

  /// What the rule makes of Lagrange's polynomials at these nodes.
  [[nodiscard]] Nodes weights_beside(const Nodes& u) const noexcept {
    // Products of the rule's distances from the nodes before each.
    std::array<Nodes, static_cast<std::size_t>(N)> before;
    Nodes product = weights_, across = Nodes::Ones();
    for (Eigen::Index i = 0; i < N; ++i) {
      before[static_cast<std::size_t>(i)] = product;
      product *= nodes_ - u[i];
      Nodes others = u - u[i];
      others[i] = 1.0;
      across *= others;
    }
    Nodes weights;
    product.setOnes();
    for (Eigen::Index i = N; i-- > 0;) {
      weights[i] = (before[static_cast<std::size_t>(i)] * product).sum();
      product *= nodes_ - u[i];
    }
    return weights / across;
  }

  Nodes nodes_, weights_;
  Eigen::Array<float, N, N> slopes_;  // column j: of all weights, as node j moves, which is by a billionth at most
};

using Kronrod = Rule<static_cast<int>(quadrature_nodes)>;
using Gauss = Rule<static_cast<int>(quadrature_nodes / 2)>;

/// Source: Piessens et al., QUADPACK, 1983, QK21: nodes on [-1, 1] down to 0 with their weights.
constexpr std::array<std::array<double, 2>, 11> positive_half{
    {{0.995657163025808080735527280689003, 0.011694638867371874278064396062192},
     {0.973906528517171720077964012084452, 0.032558162307964727478818972459390},
     {0.930157491355708226001207180059508, 0.054755896574351996031381300244580},
     {0.865063366688984510732096688423493, 0.075039674810919952767043140916190},
     {0.780817726586416897063717578345042, 0.093125454583697605535065465083366},
     {0.679409568299024406234327365114874, 0.109387158802297641899210590325805},
     {0.562757134668604683339000099272694, 0.123491976262065851077958109585166},
     {0.433395394129247190799265943165784, 0.134709217311473325928054001771707},
     {0.294392862701460198131126603103866, 0.142775938577060080797094273138717},
     {0.148874338981631210884826001129720, 0.147739104901338491374841515972068},
     {0.0, 0.149445554002916905664936468389821}}};

Kronrod kronrod_rule() {
  Kronrod::Nodes nodes, weights;
  for (Eigen::Index i = 0; i < nodes.size(); ++i) {
    const bool before = i < 10;
    const auto& [node, weight] = positive_half[static_cast<std::size_t>(before ? i : nodes.size() - 1 - i)];
    nodes[i] = 0.5 * (before ? 1.0 - node : 1.0 + node);
    weights[i] = 0.5 * weight;
  }
  return {nodes, weights};
}

/// Every second node.
Gauss::Nodes gauss_nodes_of(const Kronrod::Nodes& nodes) {
  return Eigen::Map<const Gauss::Nodes, 0, Eigen::InnerStride<2>>(nodes.data() + 1);
}

Gauss gauss_rule(const Kronrod::Nodes& nodes) {
  Gauss::Nodes weights;
  const auto rule = gauss_legendre<quadrature_nodes / 2>();
  for (std::size_t i = 0; i < rule.size(); ++i) weights[static_cast<Eigen::Index>(i)] = rule[i].weight;
  return {gauss_nodes_of(nodes), weights};
}

double rounding_of_times(double a, double b) {
  return std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

bool is_long_enough(double a, double b) { return b - a >= shortest_piece * rounding_of_times(a, b); }

}  // namespace

TimeRule time_rule(double a, double b) noexcept {
  static const Kronrod kronrod = kronrod_rule();
  static const Gauss gauss = gauss_rule(kronrod.nodes());
  TimeRule rule;
  Eigen::Map<Kronrod::Nodes> times(rule.times.data()), weights(rule.weights.data());
  times = a + kronrod.nodes() * (b - a);
  const Kronrod::Nodes u = is_long_enough(a, b) ? Kronrod::Nodes((times - a) / (b - a)) : kronrod.nodes();
  weights = kronrod.weights_at(u);
  Eigen::Map<Gauss::Nodes>(rule.gauss_weights.data()) = gauss.weights_at(gauss_nodes_of(u));
  return rule;
}

double quadrature_tolerance(double a, double b) noexcept {
  return std::max(smooth_tolerance, share_beyond * rounding_of_times(a, b) / (b - a));
}

bool can_be_halved(double a, double b) noexcept { return is_long_enough(a, 0.5 * (a + b)); }

}}  // namespace orispline
