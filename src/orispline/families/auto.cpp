// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/auto.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/window.hpp>
#include <orispline/math/elementary.hpp>

// The steps are numbered as on docs/families/auto.md, which also says where the constants come from.

namespace orispline::inline ORISPLINE_ABI::families {
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

/// By how much a step turns [rad]; positions turn by nothing.
template <CurvePoint P>
double turn_of(const Displacement<P>& step) {
  return std::same_as<P, Eigen::Quaterniond> ? step.norm() : 0.0;
}

/// (1) How far five keys are from a cubic: 0 for one, 1 for a kick or alternating noise.
double roughness_of(const Window& w) {
  std::array<Eigen::Vector3d, 3> bend;  // second divided differences
  std::array<double, 3> at;
  Eigen::Vector3d before = w.secant(0);
  for (std::size_t m = 0; m < 3; ++m) {
    const Eigen::Vector3d after = w.secant(m + 1);
    bend[m] = (2.0 / (w.times[m + 2] - w.times[m])) * (after - before);
    at[m] = (w.times[m] + w.times[m + 1] + w.times[m + 2]) / 3.0;
    before = after;
  }
  const double share = (at[2] - at[1]) / (at[2] - at[0]);
  const double size = bend[1].norm() + share * bend[0].norm() + (1.0 - share) * bend[2].norm();
  if (!(size > 0.0)) return 0.0;
  return (bend[1] - share * bend[0] - (1.0 - share) * bend[2]).norm() / size;
}

/// The two intervals beside a key: their lengths [s] and secants.
struct Beside {
  double before, after;
  Eigen::Vector3d d_before, d_after;
};

/// (4) The rates whose quintics stay nearest to the two geodesics beside key i, in the mean square.
Rates geodesic_rates(const Beside& beside) {
  constexpr double a = 52.0 / 3465.0, b = 23.0 / 18480.0, c = 1.0 / 9240.0;  // Gram matrix of the Hermite quintics
  const auto& [before, after, d_before, d_after] = beside;
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

/// Rates at the keys of a track, asked for key after key, from the first to the last. What several keys need, the
/// increments between near keys above all, is found once and kept while it is near.
template <CurvePoint P>
class RatesAlong {
 public:
  /// `reach` is 3 for auto, 2 for auto5.
  RatesAlong(const Keyframes& keys, std::size_t reach, bool hold)
      : times_(keys.times()), points_(keys.points<P>()), reach_(reach), hold_(hold) {}

  [[nodiscard]] Rates next() {
    const std::size_t i = next_++;
    for (; found_ < std::min(size(), i + ahead); ++found_) find(found_);
    if (hold_ && ((i > 0 && rests_after(i - 1)) || (i + 1 < size() && rests_after(i)))) return {};
    if (size() == 2) return {secant(0), Eigen::Vector3d::Zero()};
    const Rates rates = windowed_rates(i);
    if (i == 0 || i + 1 == size()) return rates;
    const double before = step(i - 1), after = step(i);
    const double gap = gap_share(roughness(i), std::max(after / before, before / after));
    return gap > 0.0 ? blended(rates, geodesic_rates({before, after, secant(i - 1), secant(i)}), gap) : rates;
  }

  /// From key i to the next; key i + 1 is the last that was asked for, or near to it.
  [[nodiscard]] const Eigen::Vector3d& step_from(std::size_t i) const { return known(i).to[0]; }

 private:
  static constexpr std::size_t ahead = 7;    ///< the seven keys of a window may be those that follow
  static constexpr std::size_t places = 16;  ///< at least twice as many

  struct Key {
    std::array<Eigen::Vector3d, 3> to;  ///< increments to the next keys
    double turn;                        ///< to the next one [rad]
    double roughness;                   ///< of the five keys whose last is this one
  };

  [[nodiscard]] std::size_t size() const { return times_.size(); }
  [[nodiscard]] double step(std::size_t i) const { return times_[i + 1] - times_[i]; }
  [[nodiscard]] Eigen::Vector3d secant(std::size_t i) const { return known(i).to[0] / step(i); }
  [[nodiscard]] bool rests_after(std::size_t i) const {
    return known(i).to[0].norm() <= (std::same_as<P, Eigen::Quaterniond> ? rest_angle : rest_length);
  }
  [[nodiscard]] const Key& known(std::size_t i) const { return keys_[i % places]; }

  void find(std::size_t i) {
    Key& key = keys_[i % places];
    for (std::size_t k = 1; k <= std::min(reach_, size() - 1 - i); ++k)
      key.to[k - 1] = displacement<double>(points_[i], points_[i + k]);
    key.turn = i + 1 < size() ? turn_of<P>(key.to[0]) : 0.0;
    key.roughness = i >= 4 ? roughness_of(window(i - 2, i - 4, 5)) : 1.0;
  }

  /// From key i to key j; the increment back is the opposite one.
  [[nodiscard]] Eigen::Vector3d increment(std::size_t i, std::size_t j) const {
    if (i == j) return Eigen::Vector3d::Zero();
    const std::size_t first = std::min(i, j), apart = std::max(i, j) - first;
    if (apart > reach_) return displacement<double>(points_[i], points_[j]);
    return i < j ? known(first).to[apart - 1] : Eigen::Vector3d(-known(first).to[apart - 1]);
  }

  [[nodiscard]] Window window(std::size_t centre, std::size_t first, std::size_t count) const {
    return window_of(times_, centre, first, count, [this](std::size_t i, std::size_t j) { return increment(i, j); });
  }
  /// Up to `reach` keys on either side, fewer at the ends.
  [[nodiscard]] Window cut_window(std::size_t centre, std::size_t reach) const {
    const std::size_t first = centre - std::min(centre, reach);
    return window(centre, first, std::min(size() - 1, centre + reach) - first + 1);
  }

  /// At the ends that of the nearest key with two on either side; 1 for fewer than five keys.
  [[nodiscard]] double roughness(std::size_t i) const {
    return size() < 5 ? 1.0 : known(std::clamp<std::size_t>(i, 2, size() - 3) + 2).roughness;
  }
  /// The largest whose five keys lie in the shifted window of key i.
  [[nodiscard]] double widest_roughness(std::size_t i) const {
    if (reach_ == 2 || size() < 5) return roughness(i);
    const std::size_t centre = std::clamp<std::size_t>(i, 3, std::max<std::size_t>(3, size() - 4));
    return std::max({roughness(centre - 1), roughness(centre), roughness(centre + 1)});
  }

  /// (2) Natural spline and polynomial over the window of that reach, mixed by `smooth`.
  [[nodiscard]] Rates mixed_rates(std::size_t i, std::size_t reach, double smooth) const {
    const Rates natural = natural_spline_rates(cut_window(i, reach));
    if (!(smooth > 0.0)) return natural;
    const auto between = [this](std::size_t from, std::size_t to) { return increment(from, to); };
    return blended(natural, polynomial_rates(shifted_window(times_, i, reach, between)), smooth);
  }

  /// The larger turn on one side of key i within the shifted window [rad].
  [[nodiscard]] double turn_beside(std::size_t i, std::size_t reach) const {
    const std::size_t last_key = size() - 1;
    const std::size_t first = std::min(i - std::min(i, reach), last_key - std::min(last_key, 2 * reach));
    const std::size_t last = std::min(last_key, first + 2 * reach);
    const auto sum = [&](std::size_t from, std::size_t to) {
      double turn = 0.0;
      for (std::size_t k = from; k < to; ++k) turn += known(k).turn;
      return turn;
    };
    return std::max(sum(first, i), sum(i, last));
  }

  /// (3) Narrower windows where the keys turn far.
  [[nodiscard]] Rates windowed_rates(std::size_t i) const {
    const double smooth = smooth_share(widest_roughness(i));
    const double wide = reach_ == 3 ? window_share(turn_beside(i, 3)) : 0.0;
    const double middle = (1.0 - wide) * window_share(turn_beside(i, 2));
    const double narrow = 1.0 - wide - middle;
    Rates rates;
    const auto add = [&](double share, std::size_t reach, double smooth_here) {
      if (!(share > 0.0)) return;
      const Rates part = mixed_rates(i, reach, smooth_here);
      rates.first += share * part.first;
      rates.second += share * part.second;
    };
    add(wide, 3, smooth);
    add(middle, 2, smooth);
    add(narrow, 1, 0.0);
    return rates;
  }

  std::span<const double> times_;
  std::span<const P> points_;
  std::size_t reach_;
  bool hold_;
  std::array<Key, places> keys_;
  std::size_t found_ = 0, next_ = 0;  ///< keys whose increments are known, and whose rates were asked for
};

Expected<bool> holds(const FamilySettings& settings) {
  return settings.whole("hold").map([](int hold) { return hold == 1; });
}

/// (5) A quintic in the chart of each segment's middle.
Expected<ChartCurve<5>> curve_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  const auto hold = holds(settings);
  if (!hold) return tl::unexpected(hold.error());
  RatesAlong<Eigen::Quaterniond> along(keys, reach, *hold);
  const auto next = [&along] {
    const Rates rates = along.next();
    return std::array<Eigen::Vector3d, 3>{rates.first, rates.second, Eigen::Vector3d::Zero()};
  };
  std::vector<ChartPiece<5>> pieces;
  pieces.reserve(keys.size() - 1);
  auto leaving = next();
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const auto arriving = next();
    const Eigen::Vector3d half = 0.5 * along.step_from(i);
    const Eigen::Quaterniond middle = keys.orientations()[i] * exp<double>(half);
    pieces.push_back(hermite_piece<2>(middle, -half, half, leaving, arriving, keys.times()[i + 1] - keys.times()[i]));
    leaving = arriving;
  }
  return ChartCurve<5>(key_knots(keys), std::move(pieces));
}

/// In space, which needs no chart, the Hermite quintic.
Expected<HermitePath<5>> path_of_reach(const Keyframes& keys, std::size_t reach, const FamilySettings& settings) {
  return holds(settings).map([&](bool hold) {
    RatesAlong<Eigen::Vector3d> along(keys, reach, hold);
    std::vector<HermitePath<5>::Derivatives> derivatives(keys.size());
    for (auto& derivative : derivatives) {
      const Rates rates = along.next();
      derivative = {rates.first, rates.second};
    }
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

}  // namespace orispline::inline ORISPLINE_ABI::families
