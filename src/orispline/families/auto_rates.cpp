// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/auto_rates.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/natural_spline.hpp>
#include <orispline/curve/window_polynomial.hpp>
#include <orispline/math/number.hpp>

// The steps are numbered as on docs/families/auto.md, which also says where the constants come from.

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

using Rates = WindowRates;

double switched(double x, double low, double high) noexcept {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double smooth_share(double roughness) noexcept { return 1.0 - switched(roughness, 0.15, 0.4); }

double window_share(double turn) noexcept {
  return 1.0 - switched(turn, 1.2 * std::numbers::pi, 1.6 * std::numbers::pi);
}

double gap_of(double step_ratio) noexcept {
  constexpr double log_of_5 = 1.6094379124341003, log_of_15 = 2.70805020110221;
  if (step_ratio <= 5.0) return 0.0;
  return switched(elementary::natural_logarithm(step_ratio), log_of_5, log_of_15);
}

// (4)
Rates geodesic_rates(const Beside& beside) noexcept {
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

namespace {

constexpr double seen_share = 1e-3;  // of the largest bend: one that is not smaller is as rough as it is

/// 1 up to `low` times the spline's error, 0 from `high` times on.
struct Belief {
  double low, high, log_of_low, log_of_high;

  [[nodiscard]] double operator()(double polynomial, double spline) const {
    if (!(polynomial > low * spline)) return 1.0;
    if (!(polynomial < high * spline)) return 0.0;
    return 1.0 - switched(elementary::natural_logarithm(polynomial / spline), log_of_low, log_of_high);
  }
};

/// (2) Whether the polynomial through seven keys foretells a key from the others better than their natural spline does:
/// 1 where clearly, 0 where not at all. In a window at an end of the track, whether it foretells that end too.
double polynomial_trust(const WindowPolynomial& polynomial, const NaturalSpline& spline, std::size_t centre) {
  constexpr std::size_t last = Window::capacity - 1;
  constexpr Belief inside{0.3, 1.0, -1.2039728043259361, 0.0};
  constexpr Belief with_end{4.0, 20.0, 1.3862943611198906, 2.995732273553991};
  const double of_polynomial = polynomial.left_out_error(1, last), of_spline = spline.left_out_error(1, last);
  const double trust = inside(of_polynomial, of_spline);
  if (!(trust > 0.0) || centre == last / 2) return trust;
  const std::size_t end = centre < last / 2 ? 0 : last;
  return trust * with_end(of_polynomial * polynomial.left_out_error(end, end + 1),
                          of_spline * spline.left_out_error(end, end + 1));
}

}  // namespace

/// (1)
AutoRates::Bends AutoRates::bends_of(const Window& w) {
  std::array<Eigen::Vector3d, 3> bend;  // second divided differences
  std::array<double, 3> at;
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector3d before = w.secant(0);
  for (std::size_t m = 0; m < 3; ++m) {
    const Eigen::Vector3d after = w.secant(m + 1);
    bend[m] = (2.0 / (w.times[m + 2] - w.times[m])) * (after - before);
    at[m] = (w.times[m] + w.times[m + 1] + w.times[m + 2]) / 3.0;
    least = std::min(least, w.step(m) * w.step(m + 1));
    before = after;
  }
  const double share = (at[2] - at[1]) / (at[2] - at[0]);
  const double size = bend[1].norm() + share * bend[0].norm() + (1.0 - share) * bend[2].norm();
  if (!(size > 0.0)) return {0.0, 0.0};
  return {(bend[1] - share * bend[0] - (1.0 - share) * bend[2]).norm() / size, size * least};
}

AutoRates::AutoRates(const Keyframes& keys, Through through, std::size_t reach, std::size_t kept)
    : times_(keys.times()), reach_(reach), kept_(kept) {
  if (through == Through::orientations) orientations_ = keys.orientations();
  else positions_ = keys.positions();
}

void AutoRates::go_to(std::size_t i) {
  for (; found_ < std::min(size(), i + ahead); ++found_) find(found_);
}

Rates AutoRates::rates(std::size_t i, double belief) const {
  if ((i > 0 && rests_after(i - 1)) || (i + 1 < size() && rests_after(i))) return {};
  if (size() == 2) return {secant(0), Eigen::Vector3d::Zero()};
  Rates rates = windowed_rates(i, belief);
  if (i == 0 || i + 1 == size()) return rates;
  const double before = step(i - 1), after = step(i), uneven = gap_of(std::max(after / before, before / after));
  if (!(uneven > 0.0)) return rates;
  const double gap = uneven * switched(roughness({i, i}, stretch_of(i)), 0.8, 1.0);
  return blended(rates, geodesic_rates({before, after, secant(i - 1), secant(i)}), gap);
}

Eigen::Vector3d AutoRates::found(std::size_t i, std::size_t j) const {
  return orientations_.empty() ? displacement<double>(positions_[i], positions_[j])
                               : displacement<double>(orientations_[i], orientations_[j]);
}

bool AutoRates::rests_after(std::size_t i) const {
  return longest_rest_ >= 0.0 && known(i).to[0].norm() <= longest_rest_;
}

void AutoRates::find(std::size_t i) {
  Key& key = keys_[i % places];
  for (std::size_t k = 1; k <= std::min(kept_, size() - 1 - i); ++k) key.to[k - 1] = found(i, i + k);
  key.turn = i + 1 < size() && positions_.empty() ? key.to[0].norm() : 0.0;
  key.bends = i >= 4 ? bends_of(window(i - 2, i - 4, 5)) : Bends{1.0, 0.0};
}

Eigen::Vector3d AutoRates::increment(std::size_t i, std::size_t j) const {
  if (i == j) return Eigen::Vector3d::Zero();
  const std::size_t first = std::min(i, j), apart = std::max(i, j) - first;
  if (apart > kept_) return found(i, j);
  return i < j ? known(first).to[apart - 1] : Eigen::Vector3d(-known(first).to[apart - 1]);
}

Window AutoRates::window(std::size_t centre, std::size_t first, std::size_t count) const {
  return window_of(times_, centre, first, count, increments());
}

/// Up to `reach` keys on either side, fewer at the ends.
Window AutoRates::cut_window(std::size_t centre, std::size_t reach) const {
  const std::size_t first = centre - std::min(centre, reach);
  return window(centre, first, std::min(size() - 1, centre + reach) - first + 1);
}

const AutoRates::Bends& AutoRates::bends(std::size_t i) const {
  return known(std::clamp<std::size_t>(i, 2, size() - 3) + 2).bends;
}

AutoRates::Stretch AutoRates::stretch_of(std::size_t i) const {
  if (reach_ == 2 || size() < 5) return {i, i};
  const std::size_t centre = std::clamp<std::size_t>(i, 3, std::max<std::size_t>(3, size() - 4));
  return {centre - 1, centre + 1};
}

double AutoRates::roughness(const Stretch& of, const Stretch& beside) const {
  if (size() < 5) return 1.0;
  double largest_bend = 0.0, roughest = 0.0;
  for (std::size_t k = beside.first; k <= beside.last; ++k) largest_bend = std::max(largest_bend, bends(k).size);
  const double seen = seen_share * largest_bend;
  for (std::size_t k = of.first; k <= of.last; ++k) {
    const auto& [roughness, size] = bends(k);
    roughest = std::max(roughest, size < seen ? roughness * switched(size, 0.0, seen) : roughness);
  }
  return roughest;
}

/// (2) Natural spline and polynomial over the window of that reach, mixed by `smooth`.
Rates AutoRates::mixed_rates(std::size_t i, std::size_t reach, double smooth) const {
  const Window window = shifted_window(times_, i, reach, increments());
  const NaturalSpline spline(window);
  const bool near_end = i < reach || i + reach >= size();
  Rates natural = near_end ? NaturalSpline(cut_window(i, reach)).rates() : spline.rates();
  if (!(smooth > 0.0)) return natural;
  const WindowPolynomial polynomial(window);
  if (guarded_ && window.size == Window::capacity) smooth *= polynomial_trust(polynomial, spline, window.centre);
  return smooth > 0.0 ? blended(natural, polynomial.rates(), smooth) : natural;
}

double AutoRates::turn_beside(std::size_t i, std::size_t reach) const {
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
Rates AutoRates::windowed_rates(std::size_t i, double belief) const {
  const Stretch stretch = stretch_of(i);
  const double smooth = belief * smooth_share(roughness(stretch, stretch));
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

ChartCurve<5> quintics_through(const Keyframes& keys, AutoRates& along, const RatesAt& rates_at) {
  const auto at = [&](std::size_t i) {
    along.go_to(i);
    const Rates rates = rates_at(i);
    return std::array<Eigen::Vector3d, 3>{rates.first, rates.second, Eigen::Vector3d::Zero()};
  };
  std::vector<ChartPiece<5>> pieces;
  pieces.reserve(keys.size() - 1);
  auto leaving = at(0);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const auto arriving = at(i + 1);
    pieces.push_back(hermite_piece_about_middle(keys.orientations()[i], along.step_from(i), leaving, arriving,
                                                keys.times()[i + 1] - keys.times()[i]));
    leaving = arriving;
  }
  return ChartCurve<5>(key_knots(keys), std::move(pieces));
}

HermitePath<5> quintic_path_through(const Keyframes& keys, AutoRates& along, const RatesAt& rates_at) {
  std::vector<HermitePath<5>::Derivatives> derivatives(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    along.go_to(i);
    const Rates rates = rates_at(i);
    derivatives[i] = {rates.first, rates.second};
  }
  return HermitePath<5>(key_knots(keys), {keys.positions().begin(), keys.positions().end()}, std::move(derivatives));
}

}}}  // namespace orispline::families
