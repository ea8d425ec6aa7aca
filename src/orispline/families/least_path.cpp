// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/key_knots.hpp>
#include <orispline/families/least.hpp>
#include <orispline/math/chain_elimination.hpp>
#include <orispline/math/scalar_link.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

using Derivatives = HermitePath<5>::Derivatives;

bool rests(const End& end) { return end.rule == EndRule::rest; }

/// The derivatives of orders 1 … P-1 at the positions that make ∫|p^(P)|² least, a row for each order.
template <int P>
std::vector<Eigen::Matrix<double, P - 1, 3>> least_derivatives(const Knots& knots,
                                                               std::span<const Eigen::Vector3d> positions,
                                                               const FamilySettings& settings) {
  using Chain = ChainElimination<P - 1, 0, 3, P>;
  const std::size_t last = knots.segments();
  Chain chain;
  chain.start(positions.size());
  for (std::size_t i = 0; i <= last; ++i) {
    typename Chain::Low low = Chain::Low::Zero();
    if (i < last) {
      const auto link = scalar_link<P>(knots.span(i).step());
      low.template leftCols<P - 1>() = link.template middleCols<P - 1>(1);
      low.template middleCols<P - 1>(P - 1) = link.template rightCols<P - 1>();
      low.template rightCols<3>() = -link.col(P) * (positions[i + 1] - positions[i]).transpose();
    }
    if ((i == 0 && rests(settings.start)) || (i == last && rests(settings.end))) {
      low.col(0).setZero();
      chain.fix(0);
    }
    if (i + 1 == last && rests(settings.end)) low.col(P - 1).setZero();
    static_cast<void>(chain.add(low));
  }
  std::vector<Eigen::Matrix<double, P - 1, 3>> derivatives(positions.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    chain.solve(Eigen::Vector3d::Unit(axis), [&](std::size_t i, const auto& x) { derivatives[i].col(axis) = x; });
  return derivatives;
}

/// p̈ of the cubic on a segment at its start and at its end.
std::array<Eigen::Vector3d, 2> bends(const Eigen::Vector3d& chord, const Eigen::Vector3d& leaving,
                                     const Eigen::Vector3d& arriving, double h) {
  const Eigen::Vector3d slope = chord / h;
  return {(6.0 * slope - 4.0 * leaving - 2.0 * arriving) / h, (2.0 * leaving + 4.0 * arriving - 6.0 * slope) / h};
}

/// The cubics as quintics. Both segments beside a key bend alike there; that of the longer one is rounded less.
std::vector<Derivatives> cubic_derivatives(const Knots& knots, std::span<const Eigen::Vector3d> positions,
                                           const FamilySettings& settings) {
  const auto velocities = least_derivatives<2>(knots, positions, settings);
  std::vector<Derivatives> derivatives;
  for (const auto& v : velocities) derivatives.push_back({v.row(0).transpose(), Eigen::Vector3d::Zero()});
  double before = 0.0;
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const double h = knots.span(i).step();
    const auto [start, end] = bends(positions[i + 1] - positions[i], derivatives[i][0], derivatives[i + 1][0], h);
    if (h > before) derivatives[i][1] = start;
    derivatives[i + 1][1] = end;
    before = h;
  }
  return derivatives;
}

}  // namespace

Expected<HermitePath<5>> Least::path(const Keyframes& keys, const FamilySettings& settings) {
  Knots knots = key_knots(keys);
  const auto positions = keys.positions();
  std::vector<Derivatives> derivatives;
  if (settings.choice("energy") == "jerk") {
    for (const auto& d : least_derivatives<3>(knots, positions, settings))
      derivatives.push_back({d.row(0).transpose(), d.row(1).transpose()});
  } else {
    derivatives = cubic_derivatives(knots, positions, settings);
  }
  return HermitePath<5>(std::move(knots), {positions.begin(), positions.end()}, std::move(derivatives));
}

}}}  // namespace orispline::families
