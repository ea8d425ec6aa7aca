// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/interval_times.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <orispline/curve/family.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t most_descents = 60;
constexpr double near_limit = 1e-6;  // by which a factor may be above 1
constexpr std::array barrier_weights{0.1, 0.01, 0.001, 0.0};
constexpr int most_sweeps = 200;            // per weight
constexpr int last_sweeps = 2;              // so many in a row that gain little end it
constexpr double little = 1e-4;             // of the duration
constexpr double usual_sweeps = 40.0;       // of all weights
constexpr double usual_stretchings = 20.0;  // of stretching, before and after

using Factors = Expected<std::vector<double>> (LimitedMotion::*)(std::vector<double>) const;

std::vector<double> times_of(double first, std::span<const double> intervals) {
  std::vector<double> times{first};
  for (const double interval : intervals) times.push_back(times.back() + interval);
  return times;
}

/// Every interval stretched by what it needs and, so that steps stay alike, by the root of what its neighbours need.
Expected<std::vector<double>> stretched(const LimitedMotion& motion, std::vector<double> times, Factors factors_at) {
  for (std::size_t round = 0; round < most_descents; ++round) {
    const auto factors = (motion.*factors_at)(times);
    if (!factors) return tl::unexpected(factors.error());
    if (!(std::ranges::max(*factors) > 1.0 + near_limit)) break;
    std::vector<double> next{times.front()};
    for (std::size_t s = 0; s < factors->size(); ++s) {
      double factor = std::max(1.0, (*factors)[s]);
      if (s > 0) factor = std::max(factor, std::sqrt((*factors)[s - 1]));
      if (s + 1 < factors->size()) factor = std::max(factor, std::sqrt((*factors)[s + 1]));
      next.push_back(next.back() + (motion.is_rest(s) ? 1.0 : factor) * (times[s + 1] - times[s]));
    }
    times = std::move(next);
  }
  return times;
}

/// Coordinate descent on the intervals between keys, within the limits all the time.
class IntervalDescent {
 public:
  IntervalDescent(const LimitedMotion& motion, std::span<const double> times, std::vector<double> factors,
                  std::size_t reach)
      : motion_(motion), first_(times.front()), reach_(reach), factors_(std::move(factors)) {
    const double time_scale = std::max(1.0, std::ranges::max(factors_)) * (1.0 + near_limit);
    for (std::size_t s = 0; s + 1 < times.size(); ++s) {
      least_.push_back(motion.least_interval(s));
      intervals_.push_back((times[s + 1] - times[s]) * (motion.is_rest(s) ? 1.0 : time_scale));
    }
    for (double& factor : factors_) factor /= time_scale;
    steps_.assign(intervals_.size(), -0.1);
  }

  [[nodiscard]] std::vector<double> run() {
    for (const double weight : barrier_weights) {
      weight_ = weight;
      widths_ = intervals_;
      double before = duration();
      for (int sweep = 0, last = 0; sweep < most_sweeps && last < last_sweeps; ++sweep) {
        for (std::size_t first = 0; first <= 2 * reach_ && first < intervals_.size(); ++first) move_every(first);
        const double after = duration();
        last = std::abs(before - after) < little * after ? last + 1 : 0;
        before = after;
      }
    }
    use_the_rest();
    return times_of(first_, intervals_);
  }

 private:
  [[nodiscard]] double duration() const { return std::accumulate(intervals_.begin(), intervals_.end(), 0.0); }

  /// What the barrier left free of the limits, as one factor.
  void use_the_rest() {
    const double factor = std::ranges::max(factors_);
    for (std::size_t i = 0; i < intervals_.size(); ++i)
      if (!motion_.is_rest(i)) intervals_[i] = std::max(least_[i], factor * intervals_[i]);
  }

  /// Moves the intervals `first`, `first` + 2 reach + 1, …, no two of which reach the same segment.
  void move_every(std::size_t first) {
    std::vector<double> moved = intervals_;
    const std::size_t stride = 2 * reach_ + 1;
    for (std::size_t i = first; i < moved.size(); i += stride)
      if (!motion_.is_rest(i)) moved[i] = std::max(least_[i], intervals_[i] * (1.0 + steps_[i]));
    const auto factors = motion_.sampled_factors(times_of(first_, moved));
    for (std::size_t i = first; i < moved.size(); i += stride) {
      const bool lower =
          factors && moved[i] != intervals_[i] && cost(moved[i], i, *factors) < cost(intervals_[i], i, factors_);
      if (!lower) {
        steps_[i] *= -0.5;
        continue;
      }
      intervals_[i] = moved[i];
      steps_[i] = std::clamp(1.7 * steps_[i], -0.5, 1.0);
      for (std::size_t s = first_reached(i); s <= last_reached(i); ++s) factors_[s] = (*factors)[s];
    }
  }

  /// The part of what is minimised that an interval changes.
  [[nodiscard]] double cost(double interval, std::size_t i, std::span<const double> factors) const {
    double barrier = -widths_[i] * elementary::natural_logarithm(interval / widths_[i]);
    for (std::size_t s = first_reached(i); s <= last_reached(i); ++s) {
      if (!(factors[s] < 1.0)) return std::numeric_limits<double>::infinity();
      barrier -= widths_[s] * elementary::natural_logarithm(1.0 - factors[s]);
    }
    return interval + weight_ * barrier;
  }
  [[nodiscard]] std::size_t first_reached(std::size_t i) const { return i - std::min(i, reach_); }
  [[nodiscard]] std::size_t last_reached(std::size_t i) const { return std::min(i + reach_, intervals_.size() - 1); }

  const LimitedMotion& motion_;
  double first_;
  std::size_t reach_;
  double weight_ = 0.0;
  std::vector<double> least_, intervals_, widths_, factors_, steps_;
};

/// How far the influence of an interval goes, in segments.
std::size_t reach_of(int support_keys) { return static_cast<std::size_t>(support_keys - 2); }

struct Start {
  std::vector<double> times, factors;
};

/// Where a descent begins: at times that keep the limits, but for what one factor mends. Rests do not scale, so that
/// one factor for all else may have to be found in several rounds.
Expected<Start> within_limits(const LimitedMotion& motion, std::vector<double> times) {
  for (std::size_t round = 0;; ++round) {
    auto factors = motion.sampled_factors(times);
    if (!factors) return tl::unexpected(std::move(factors.error()));
    const double factor = std::ranges::max(*factors);
    if (!motion.has_rests() || !(factor > 1.0) || round == most_descents)
      return Start{std::move(times), std::move(*factors)};
    times = motion.lengthened(std::move(times), factor * (1.0 + near_limit));
  }
}

}  // namespace

double curves_for_interval_times(int support_keys) noexcept {
  if (support_keys == all_keys) return usual_stretchings;
  return usual_stretchings + usual_sweeps * static_cast<double>(2 * reach_of(support_keys) + 1);
}

Expected<std::vector<double>> least_interval_times(const LimitedMotion& motion, std::vector<double> times,
                                                   int support_keys) {
  auto enough = stretched(motion, std::move(times), &LimitedMotion::sampled_factors);
  if (!enough) return enough;
  if (support_keys != all_keys) {
    auto start = within_limits(motion, std::move(*enough));
    if (!start) return tl::unexpected(std::move(start.error()));
    enough = IntervalDescent(motion, start->times, std::move(start->factors), reach_of(support_keys)).run();
  }
  return stretched(motion, std::move(*enough), &LimitedMotion::certified_factors);
}

}}  // namespace orispline
