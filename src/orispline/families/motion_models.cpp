// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/auto_rates.hpp>
#include <orispline/families/window_differences.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

using models::Covariances;
using models::Differences;
using models::in_lanes;
using models::inner_window_keys;
using models::product;
using Noise = models::Lanes<static_cast<int>(noise_models)>;

const Noise& noise_share() {
  static const Noise share = Eigen::Map<const Noise>(noise_shares.data());
  return share;
}

/// Those of the cubic spline, 3/2 of ∫ of two hats, and those of the noise of variance f/6.
Covariances<Noise::RowsAtCompileTime, 2> noise_covariances(const Differences& d) {
  const Noise noise = noise_share() / 6.0, motion = 1.0 - noise_share();
  Covariances<Noise::RowsAtCompileTime, 2> covariances;
  std::array<Noise, inner_window_keys> diagonal;
  for (std::size_t i = 0; i < inner_window_keys; ++i) {
    covariances.m[i][i] = diagonal[i] = motion * (0.5 * (d.step(i) + d.step(i + 1))) + noise * d.overlap(i, i);
    if (i > 0) covariances.m[i][i - 1] = motion * (0.25 * d.step(i)) + noise * d.overlap(i - 1, i);
    if (i > 1) covariances.m[i][i - 2] = noise * d.overlap(i - 2, i);
  }
  covariances.factorise(diagonal);
  return covariances;
}

/// Derivatives of the curve that joins what the smoothing spline leaves of the keys near the geodesics, from the rest.
std::array<std::array<double, window_keys>, 2> rest_rates(const Differences& d) {
  const std::size_t p = d.centre(), before = std::max<std::size_t>(p, 1) - 1, after = d.interval();
  const WindowRates unit =
      geodesic_rates({d.step(before), d.step(after), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()});
  std::array<std::array<double, window_keys>, 2> rates{};
  for (std::size_t order = 0; order < 2; ++order) {
    const Eigen::Vector3d& of = order == 0 ? unit.first : unit.second;
    const double by_before = of.x() / d.step(before), by_after = of.y() / d.step(after);
    rates[order][before] -= by_before;
    rates[order][before + 1] += by_before;
    rates[order][after] -= by_after;
    rates[order][after + 1] += by_after;
  }
  return rates;
}

/// The spline's second derivative at key m + 1 is 3/2 (1 - f) times the unknown m; its slope follows from that and from
/// what it leaves of the keys, f/6 times the sum of differences there.
void put_noise_maps(ModelMaps& maps, const Differences& d) {
  const Noise noise = noise_share() / 6.0, motion = 1.0 - noise_share();
  const std::size_t p = d.centre(), n = d.interval();
  auto rest = rest_rates(d);
  rest[0][n + 1] -= 1.0 / d.step(n);
  rest[0][n] += 1.0 / d.step(n);
  const auto first_rest = d.of(rest[0]), second_rest = d.of(rest[1]);
  std::array<Noise, inner_window_keys> first, second;
  for (std::size_t m = 0; m < inner_window_keys; ++m) {
    const double bends = m + 1 == p ? 1.0 : 0.0, bends_beyond = m + 1 == (p == n ? p + 1 : p - 1) ? 1.0 : 0.0;
    const double slope = 0.25 * d.step(n) * (2.0 * bends + bends_beyond);
    first[m] = noise * first_rest[m] + motion * (p == n ? -slope : slope);
    second[m] = noise * second_rest[m] + motion * (1.5 * bends);
  }
  models::put_maps<0>(maps, d, noise_covariances(d), first, second);
}

}  // namespace

ModelMaps model_maps(const WindowTimes& window) {
  const Differences d(window);
  ModelMaps maps;
  put_noise_maps(maps, d);
  models::put_velocity_maps(maps, d);
  return maps;
}

PerModel model_variances(const WindowTimes& window) {
  const Differences d(window);
  PerModel variances = model_maps(window).precision.inverse();
  const std::size_t p = window.centre;
  const double share = d.step(p - 1) / (d.step(p - 1) + d.step(p));
  std::array<double, window_keys> joined{};
  joined[p - 1] = 1.0 - share;
  joined[p + 1] = share;
  const auto hat = d.of(joined), centre = d.of_key(p);
  const auto solved = noise_covariances(d).solve(in_lanes<Noise::RowsAtCompileTime>(hat));
  const Noise noise = noise_share() / 6.0, along = product(centre, solved);
  variances.head<Noise::RowsAtCompileTime>() +=
      noise.square() * (product(hat, solved) - along.square() * variances.head<Noise::RowsAtCompileTime>());
  return variances;
}

}}}  // namespace orispline::families
