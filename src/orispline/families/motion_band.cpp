// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/motion_band.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <orispline/base/formatted.hpp>
#include <orispline/families/key_windows.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using namespace families;

constexpr double smallest = 1e-300;  // divides nothing by 0

/// What the band takes of each key.
struct KeyWidth {
  double trust;             ///< 0 at the ends of the track, whose neighbours are on one side
  double believed;          ///< how far a polynomial is
  PerModel miss_variances;  ///< of a miss, by unit variance of each model
  double miss;              ///< squared, by the models together [rad²]
  double relative;          ///< the same as a share of what is expected
};

struct Widths {
  std::vector<KeyWidth> keys;
  PerModel variances;       ///< of the models, by their misses, times their shares
  double polynomial = 1.0;  ///< squared misses of the polynomial as a share of those of the plain spline, 1 at most
};

/// The shares of the models that count for the band, 1 together.
PerModel band_shares(const KeyFindings& findings) {
  constexpr double least_share = 1e-3;
  PerModel shares = Eigen::Map<const PerModel>(findings.belief.models.data());
  shares = (shares > least_share).select(shares, 0.0);
  return shares / shares.sum();
}

Widths widths_of(const Keyframes& keys, const KeyFindings& findings) {
  const PerModel shares = band_shares(findings);
  Widths widths{.keys = {}, .variances = PerModel::Zero()};
  widths.keys.reserve(keys.size());
  KeyWindows windows(keys, Through::orientations, findings.interval);
  double trusted = 0.0, by_polynomial = 0.0, by_spline = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    windows.go_to(i);
    const WindowMaps& maps = windows.maps();
    const bool inside = i > 0 && i + 1 < keys.size();
    KeyWidth key{.trust = inside ? windows.trust() : 0.0,
                 .believed = findings.belief.polynomial * windows.smooth(),
                 .miss_variances = maps.models.precision.inverse(),
                 .miss = 0.0,
                 .relative = 0.0};
    if (windows.trust() > 0.0) {
      const KeyMisses misses = windows.misses();
      std::array<double, window_keys> together;
      for (std::size_t j = 0; j < window_keys; ++j) together[j] = (maps.models.miss[j] * shares).sum();
      key.miss = windows.applied(together).squaredNorm();
      widths.variances += key.trust * misses.models * maps.models.precision;
      trusted += key.trust;
      by_spline += misses.smooth * misses.models[0];
      const double nine = findings.belief.polynomial9;
      if (misses.smooth > 0.0)
        by_polynomial +=
            misses.smooth * ((1.0 - nine) * misses.seven + nine * windows.applied(maps.miss9).squaredNorm());
    }
    widths.keys.push_back(key);
  }
  widths.variances *= shares / std::max(3.0 * trusted, smallest);
  for (KeyWidth& key : widths.keys)
    key.relative = key.miss / std::max(3.0 * (widths.variances * key.miss_variances).sum(), smallest);
  if (by_spline > 0.0) widths.polynomial = std::min(1.0, by_polynomial / by_spline);
  return widths;
}

/// How much the keys around key i miss, nearer ones more, as a share of what is usual; `own`: what the key's own miss
/// counts.
double activity(const std::vector<KeyWidth>& keys, std::size_t i, double own) {
  constexpr std::size_t reach = 4;
  constexpr double usual = 4.0;  // keys that miss as usual, counted beside those there are
  double sum = usual, count = usual;
  for (std::size_t j = i - std::min(i, reach); j <= std::min(i + reach, keys.size() - 1); ++j) {
    const double apart = static_cast<double>(j > i ? j - i : i - j);
    const double weight = (j == i ? own : (5.0 - apart) / 4.0) * keys[j].trust;
    sum += weight * keys[j].relative;
    count += weight;
  }
  return std::sqrt(sum / count);
}

/// The factor that a share of the keys does not miss by more; infinite where none is trusted.
double factor_of(const std::vector<KeyWidth>& keys, double share) {
  std::vector<std::pair<double, double>> misses;  // and their weights
  double all = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!(keys[i].trust > 0.0)) continue;
    misses.emplace_back(std::sqrt(keys[i].relative) / activity(keys, i, 0.0), keys[i].trust);
    all += keys[i].trust;
  }
  std::ranges::sort(misses);
  double sum = 0.0;
  for (const auto& [miss, weight] : misses) {
    sum += weight;
    if (sum >= share * all) return miss;
  }
  return misses.empty() ? std::numeric_limits<double>::infinity() : misses.back().first;
}

/// The times of the eight keys around a segment and of a time between, seen from that.
WindowTimes around(std::span<const double> times, std::size_t segment, double fraction, double interval) {
  constexpr std::size_t count = window_keys - 1;
  const std::size_t first = std::min(segment - std::min<std::size_t>(segment, 3), times.size() - count);
  const double after = fraction * (times[segment + 1] - times[segment]);
  WindowTimes window{.x = {}, .centre = segment - first + 1};
  for (std::size_t j = 0; j < count; ++j)
    window.x[j + (j < window.centre ? 0 : 1)] = (times[first + j] - times[segment] - after) / interval;
  return window;
}

}  // namespace

Expected<MotionBand> MotionBand::make(const Method& method, const Keyframes& keys, double share) {
  if (!(share > 0.0 && share < 1.0))
    return failure(ErrorCode::bad_argument, formatted("the share of a band is {}, wanted between 0 and 1", share));
  if (method.name != Measured::info.name)
    return failure(ErrorCode::bad_argument,
                   formatted("method '{}' has no band, wanted '{}'", method.name, Measured::info.name));
  const auto findings = key_findings(method, keys);
  if (!findings) return tl::unexpected(findings.error());
  MotionBand band;
  band.times_.assign(keys.times().begin(), keys.times().end());
  if (!*findings) return band;
  const Widths widths = widths_of(keys, **findings);
  const double factor = factor_of(widths.keys, share);
  if (!std::isfinite(factor)) return band;
  for (std::size_t i = 0; i < keys.size(); ++i)
    band.activity_.push_back(factor * activity(widths.keys, i, 1.0) *
                             std::sqrt(1.0 - widths.keys[i].believed * (1.0 - widths.polynomial)));
  constexpr double least = 0.06;  // of what no key can show, by the variance of a miss
  constexpr std::array<double, 3> of_least{0.75, 1.0, 0.75};
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const PerModel shown_by_none = 0.5 * least * (widths.keys[i].miss_variances + widths.keys[i + 1].miss_variances);
    std::array<double, 3> variance;  // at quarters of the segment
    for (std::size_t k = 0; k < 3; ++k) {
      const WindowTimes window = around(keys.times(), i, 0.25 * static_cast<double>(k + 1), (*findings)->interval);
      const PerModel unit = model_variances(window).max(0.0) + of_least[k] * shown_by_none;
      variance[k] = std::max((widths.variances * unit).sum(), smallest);
    }
    const auto power = [&](double quarter) {
      constexpr double log_of_three_quarters = -0.2876820724517809;
      const double drop = elementary::natural_logarithm(std::max(quarter, smallest) / variance[1]);
      return std::clamp(drop / log_of_three_quarters, 0.0, 6.0);
    };
    band.segments_.push_back({std::sqrt(3.0 * variance[1]), {0.5 * power(variance[0]), 0.5 * power(variance[2])}});
  }
  return band;
}

double MotionBand::operator()(double t) const noexcept {
  if (segments_.empty()) return std::isnan(t) ? t : std::numeric_limits<double>::infinity();
  const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  const auto i = static_cast<std::size_t>(next - times_.begin()) - 1;
  const double x = std::clamp((t - times_[i]) / (times_[i + 1] - times_[i]), 0.0, 1.0);
  const double power = segments_[i].power[x < 0.5 ? 0 : 1];
  const double narrowed =
      power > 0.0 ? elementary::exponential(power * elementary::natural_logarithm(4.0 * x * (1.0 - x))) : 1.0;
  const double width = segments_[i].middle * narrowed;
  return width * ((1.0 - x) * activity_[i] + x * activity_[i + 1]);
}

}}  // namespace orispline
