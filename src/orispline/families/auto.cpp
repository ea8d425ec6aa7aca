// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/auto.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <orispline/curve/increments.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/window.hpp>
#include <orispline/math/elementary.hpp>

// The steps are numbered as on docs/families/auto.md, which also says where the constants come from.

namespace orispline::families {
namespace {

using Rates = WindowRates;

/// Smooth switch: 0 up to `low`, 1 from `high` on.
double switched(double x, double low, double high) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double smooth_share(double roughness) { return 1.0 - switched(roughness, 0.15, 0.4); }
/// Share of a wide window whose larger side turns by `turn` [rad]: logarithms must stay well inside a full turn.
double window_share(double turn) { return 1.0 - switched(turn, 1.2 * std::numbers::pi, 1.6 * std::numbers::pi); }

constexpr double log_of_5 = 1.6094379124341003, log_of_15 = 2.70805020110221;
double gap_share(double roughness, double step_ratio) {
  return switched(roughness, 0.8, 1.0) * switched(elementary::natural_logarithm(step_ratio), log_of_5, log_of_15);
}

/// The keys as the method sees them: the same for orientations and for positions.
struct Track {
  std::span<const double> times;
  std::function<Eigen::Vector3d(std::size_t, std::size_t)> displacement;  ///< increment from key i to key j
  std::vector<Eigen::Vector3d> increments;                                ///< between neighbours
  std::vector<double> turns;                                              ///< their angles; zeros for positions
  std::size_t reach;                                                      ///< 3 for auto, 2 for auto5

  [[nodiscard]] std::size_t size() const { return times.size(); }
  [[nodiscard]] double step(std::size_t i) const { return times[i + 1] - times[i]; }
  [[nodiscard]] Eigen::Vector3d secant(std::size_t i) const { return increments[i] / step(i); }

  /// Up to `reach` keys on either side, fewer at the ends.
  [[nodiscard]] Window cut_window(std::size_t centre, std::size_t reach_) const {
    const std::size_t first = centre - std::min(centre, reach_);
    return window_of(times, centre, first, std::min(size() - 1, centre + reach_) - first + 1, displacement);
  }
};

/// (1) How far five keys are from a cubic: 0 for one, 1 for a kick or alternating noise.
double roughness_of(const Window& w) {
  std::array<Eigen::Vector3d, 3> bend;  // second divided differences
  std::array<double, 3> at;
  for (std::size_t m = 0; m < 3; ++m) {
    bend[m] = 2.0 * (w.secant(m + 1) - w.secant(m)) / (w.times[m + 2] - w.times[m]);
    at[m] = (w.times[m] + w.times[m + 1] + w.times[m + 2]) / 3.0;
  }
  const double share = (at[2] - at[1]) / (at[2] - at[0]);
  const double size = bend[1].norm() + share * bend[0].norm() + (1.0 - share) * bend[2].norm();
  if (!(size > 0.0)) return 0.0;
  return (bend[1] - share * bend[0] - (1.0 - share) * bend[2]).norm() / size;
}

std::vector<double> roughness_at_keys(const Track& track) {
  const std::size_t n = track.size();
  std::vector<double> r(n, 1.0);
  if (n < 5) return r;
  for (std::size_t i = 2; i + 2 < n; ++i) r[i] = roughness_of(track.cut_window(i, 2));
  r[0] = r[1] = r[2];
  r[n - 1] = r[n - 2] = r[n - 3];
  return r;
}

/// The largest roughness whose five keys lie in the seven-key window of key i.
double widest_roughness(const std::vector<double>& r, std::size_t i) {
  const std::size_t n = r.size();
  if (n < 5) return 1.0;
  const std::size_t centre = std::clamp<std::size_t>(i, 3, std::max<std::size_t>(3, n - 4));
  const auto at = [&](std::size_t k) { return r[std::clamp<std::size_t>(k, 2, std::max<std::size_t>(2, n - 3))]; };
  return std::max({at(centre - 1), at(centre), at(centre + 1)});
}

/// (2) Natural spline and polynomial over the window of that reach, mixed by `smooth`.
Rates mixed_rates(const Track& track, std::size_t i, std::size_t reach, double smooth) {
  const Rates natural = natural_spline_rates(track.cut_window(i, reach));
  if (!(smooth > 0.0)) return natural;
  return blended(natural, polynomial_rates(shifted_window(track.times, i, reach, track.displacement)), smooth);
}

/// The larger turn on one side of key i within the shifted window [rad].
double turn_beside(const Track& track, std::size_t i, std::size_t reach) {
  const std::size_t first = std::min(i - std::min(i, reach), track.size() - 1 - std::min(track.size() - 1, 2 * reach));
  const std::size_t last = std::min(track.size() - 1, first + 2 * reach);
  const auto sum = [&](std::size_t from, std::size_t to) {
    double turn = 0.0;
    for (std::size_t k = from; k < to; ++k) turn += track.turns[k];
    return turn;
  };
  return std::max(sum(first, i), sum(i, last));
}

/// (3) The widest window that the steps allow, blended with the narrower ones.
Rates windowed_rates(const Track& track, std::size_t i, double smooth) {
  const double wide = track.reach == 3 ? window_share(turn_beside(track, i, 3)) : 0.0;
  const double middle = (1.0 - wide) * window_share(turn_beside(track, i, 2));
  const double narrow = 1.0 - wide - middle;
  Rates rates;
  const auto add = [&](double share, std::size_t reach, double smooth_here) {
    if (!(share > 0.0)) return;
    const Rates part = mixed_rates(track, i, reach, smooth_here);
    rates.first += share * part.first;
    rates.second += share * part.second;
  };
  add(wide, 3, smooth);
  add(middle, 2, smooth);
  add(narrow, 1, 0.0);
  return rates;
}

/// (4) The rates whose quintics stay nearest to the two geodesics beside key i, in the mean square.
Rates geodesic_rates(const Track& track, std::size_t i) {
  constexpr double a = 52.0 / 3465.0, b = 23.0 / 18480.0, c = 1.0 / 9240.0;  // Gram matrix of the Hermite quintics
  const double before = track.step(i - 1), after = track.step(i);
  const Eigen::Vector3d d_before = track.secant(i - 1), d_after = track.secant(i);
  const double after3 = after * after * after, after4 = after3 * after;
  const double before3 = before * before * before, before4 = before3 * before;
  const double fifth = after4 * after + before4 * before;
  const double coupling = b * b / c * (after4 - before4) / fifth;
  const double w_after = a * after3 - coupling * after4;
  const double w_before = a * before3 + coupling * before4;
  const Eigen::Vector3d first = (w_after * d_after + w_before * d_before) / (w_after + w_before);
  const Eigen::Vector3d second = -b / c * (after4 * (first - d_after) - before4 * (first - d_before)) / fifth;
  return {first, second};
}

std::vector<Rates> rates_at_keys(const Track& track, bool hold) {
  const std::size_t n = track.size();
  std::vector<Rates> rates(n);
  if (n == 2) {
    rates[0].first = rates[1].first = track.secant(0);
  } else {
    const std::vector<double> roughness = roughness_at_keys(track);
    for (std::size_t i = 0; i < n; ++i) {
      const double rough = track.reach == 3 ? widest_roughness(roughness, i) : roughness[i];
      rates[i] = windowed_rates(track, i, smooth_share(rough));
      if (i == 0 || i + 1 == n) continue;
      const double ratio = track.step(i) / track.step(i - 1);
      const double gap = gap_share(roughness[i], std::max(ratio, 1.0 / ratio));
      if (gap > 0.0) rates[i] = blended(rates[i], geodesic_rates(track, i), gap);
    }
  }
  if (hold)
    for (std::size_t i = 0; i + 1 < n; ++i)
      if (track.increments[i].isZero(0.0)) rates[i] = rates[i + 1] = Rates{};
  return rates;
}

Track orientation_track(const Keyframes& keys, std::size_t reach) {
  const auto q = keys.orientations();
  Track track{.times = keys.times(),
              .displacement = [q](std::size_t i, std::size_t j) { return increment<double>(q[i], q[j]); },
              .increments = increments_between(q),
              .turns = {},
              .reach = reach};
  for (const Eigen::Vector3d& phi : track.increments) track.turns.push_back(phi.norm());
  return track;
}

Track position_track(const Keyframes& keys, std::size_t reach) {
  const auto p = keys.positions();
  return {.times = keys.times(),
          .displacement = [p](std::size_t i, std::size_t j) -> Eigen::Vector3d { return p[j] - p[i]; },
          .increments = increments_between(p),
          .turns = std::vector<double>(p.size() - 1, 0.0),
          .reach = reach};
}

Expected<bool> holds(const FamilySettings& settings) {
  return settings.whole("hold").map([](int hold) { return hold == 1; });
}

/// (5) A quintic in the chart of each segment's middle.
Expected<ChartCurve<5>> curve_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  const auto hold = holds(settings);
  if (!hold) return tl::unexpected(hold.error());
  const Track track = orientation_track(keys, reach);
  const std::vector<Rates> rates = rates_at_keys(track, *hold);
  const auto at = [&rates](std::size_t i) {
    return std::array<Eigen::Vector3d, 3>{rates[i].first, rates[i].second, Eigen::Vector3d::Zero()};
  };
  std::vector<ChartPiece<5>> pieces;
  pieces.reserve(keys.size() - 1);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const Eigen::Vector3d half = 0.5 * track.increments[i];
    const Eigen::Quaterniond middle = keys.orientations()[i] * exp<double>(half);
    pieces.push_back(hermite_piece<2>(middle, -half, half, at(i), at(i + 1), track.step(i)));
  }
  return ChartCurve<5>(key_knots(keys), std::move(pieces));
}

Expected<HermitePath<5>> path_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  return holds(settings).map([&](bool hold) {
    std::vector<HermitePath<5>::Derivatives> derivatives;
    for (const Rates& r : rates_at_keys(position_track(keys, reach), hold)) derivatives.push_back({r.first, r.second});
    return HermitePath<5>(key_knots(keys), {keys.positions().begin(), keys.positions().end()}, std::move(derivatives));
  });
}

}  // namespace

Expected<ChartCurve<5>> Auto::curve(const Keyframes& keys, const FamilySettings& settings) {
  return curve_of_reach(keys, 3, settings);
}
Expected<HermitePath<5>> Auto::path(const Keyframes& keys, const FamilySettings& settings) {
  return path_of_reach(keys, 3, settings);
}
Expected<ChartCurve<5>> Auto5::curve(const Keyframes& keys, const FamilySettings& settings) {
  return curve_of_reach(keys, 2, settings);
}
Expected<HermitePath<5>> Auto5::path(const Keyframes& keys, const FamilySettings& settings) {
  return path_of_reach(keys, 2, settings);
}

}  // namespace orispline::families
