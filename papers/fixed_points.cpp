// SPDX-License-Identifier: Apache-2.0
#include "papers/fixed_points.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <orispline/families/nu_construction.hpp>
#include <orispline/families/registry.hpp>

namespace orispline::cli {

namespace {

using Controls = std::vector<Eigen::Quaterniond>;
using Ratios = families::NuRatios<double>;

double farthest(const Controls& a, std::span<const Eigen::Quaterniond> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, angular_distance(a[i], b[i]));
  return largest;
}

/// Sweeps from the keys on. `at_keys` has the curve's orientations at the keys' times.
Sweeps counted(const Keyframes& keys, const std::function<Controls(const Controls&)>& swept,
               const std::function<Controls(const Controls&)>& at_keys) {
  const auto q = keys.orientations();
  Controls controls(q.begin(), q.end());
  Sweeps sweeps;
  for (std::size_t k = 1; k <= most_sweeps && !(sweeps.until_near && sweeps.until_still); ++k) {
    Controls next = swept(controls);
    const double moved = farthest(next, controls);
    controls = std::move(next);
    if (!sweeps.until_near && farthest(at_keys(controls), q) <= published_tolerance) sweeps.until_near = k;
    if (!sweeps.until_still && moved <= published_tolerance) sweeps.until_still = k;
  }
  return sweeps;
}

/// Controls at the times of the keys; where they are none that a curve takes, NaN comes out and nothing converges.
Controls on_bspline(const Keyframes& keys, const Controls& controls) {
  Controls found(controls.size(), Eigen::Quaterniond(Eigen::Vector4d::Constant(std::nan(""))));
  const auto times = keys.times();
  const auto curve = Keyframes::make({.times = {times.begin(), times.end()}, .orientations = controls})
                         .and_then([](const Keyframes& made) { return make_curve("bspline", made); });
  if (curve) std::ranges::transform(times, found.begin(), [&](double t) { return (*curve)(t); });
  return found;
}

/// The share of an end in a slerp over an angle: sin(s θ)/sin θ.
double slerp_weight(double s, double angle) { return angle < 1e-9 ? s : std::sin(s * angle) / std::sin(angle); }

/// Half the angle of the rotation between them.
double arc(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return 0.5 * angular_distance(a, b); }

/// The control in the middle of three such that G(G(before, it; λ), G(it, after; μ); δ) is the key, angles as they are.
Eigen::Quaterniond between_neighbours(const Controls& d, std::size_t i, const Eigen::Quaterniond& key,
                                      const Ratios& ratios) {
  const double lambda = ratios.before[i], mu = ratios.after[i], delta = ratios.key[i];
  const double before = arc(d[i - 1], d[i]), after = arc(d[i], d[i + 1]);
  const double across = arc(slerp<double>(d[i - 1], d[i], lambda), slerp<double>(d[i], d[i + 1], mu));
  const double left = slerp_weight(1.0 - delta, across), right = slerp_weight(delta, across);
  const Eigen::Vector4d others = left * slerp_weight(1.0 - lambda, before) * d[i - 1].coeffs() +
                                 right * slerp_weight(mu, after) * d[i + 1].coeffs();
  return Eigen::Quaterniond(Eigen::Vector4d(key.coeffs() - others)).normalized();
}

}  // namespace

Sweeps bspline_sweeps(const Keyframes& keys, double share) {
  const auto at_keys = [&](const Controls& p) { return on_bspline(keys, p); };
  const auto swept = [&](const Controls& p) {
    const Controls on_curve = at_keys(p);
    Controls next;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Eigen::Vector3d missing = increment<double>(on_curve[i], keys.orientations()[i]);
      next.push_back(p[i] * exp<double>(Eigen::Vector3d(share * missing)));
    }
    return next;
  };
  return counted(keys, swept, at_keys);
}

Sweeps nu_sweeps(const Keyframes& keys, NuEnds ends) {
  const auto q = keys.orientations();
  const std::size_t last = q.size() - 1;
  const Ratios ratios = families::nu_ratios<double>({keys.times()}, std::vector<double>(q.size(), 1.0));  // γ of ν = 0
  const auto swept = [&](const Controls& d) {
    Controls next(q.begin(), q.end());
    for (std::size_t i = 1; i < last; ++i) next[i] = between_neighbours(d, i, q[i], ratios);
    if (ends == NuEnds::rest) return next;
    const double first = ratios.before[1], end = 1.0 - ratios.after[last - 1];
    next[0] = slerp<double>(q[0], d[1], first / (1.0 + first));
    next[last] = slerp<double>(q[last], d[last - 1], end / (1.0 + end));
    return next;
  };
  const auto at_keys = [&](const Controls& d) {
    Controls found(q.begin(), q.end());
    for (std::size_t i = 1; i < last; ++i)
      found[i] = slerp<double>(slerp<double>(d[i - 1], d[i], ratios.before[i]),
                               slerp<double>(d[i], d[i + 1], ratios.after[i]), ratios.key[i]);
    return found;
  };
  return counted(keys, swept, at_keys);
}

}  // namespace orispline::cli
