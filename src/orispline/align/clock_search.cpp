// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/clock_search.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_element.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t most_candidates = 5;
constexpr double most_intervals_of_shorter = 4096, most_intervals_of_longer = 65536, least_intervals = 32;
constexpr double most_intervals = 1 << 20;  // of the longer one beside a much shorter one
constexpr double least_overlap = 0.5;       // of the shorter one

double duration_of(const AnyCurve& curve) { return curve.domain().end - curve.domain().start; }

/// Long enough for the search to end, no shorter than samples are apart.
double interval_for(const AnyCurve& moved, const AnyCurve& fixed, double sampling_interval) {
  const auto [shorter, longer] = std::minmax({duration_of(moved), duration_of(fixed)});
  const double interval =
      std::max({sampling_interval, shorter / most_intervals_of_shorter, longer / most_intervals_of_longer});
  return std::min(interval, shorter / least_intervals);
}

std::vector<double> angles_turned(const AnyCurve& curve, double interval) {
  const auto count = static_cast<std::size_t>(duration_of(curve) / interval * (1.0 + 1e-12));
  std::vector<double> angles;
  for (const Eigen::Vector3d& turn : turns_in_intervals(curve, curve.domain().start, interval, count))
    angles.push_back(turn.norm());
  return angles;
}

/// What the difference of two angles counts, at most `enough`.
struct Unlikeness {
  double enough;  // what half of the pairs of any intervals differ by at least
  double usual;   // the mean over pairs of any intervals

  Unlikeness(std::span<const double> a, std::span<const double> b) {
    constexpr std::size_t pairs = 4096, stride_a = 7919, stride_b = 104729;  // primes: no period of the motion
    std::vector<double> differences;
    for (std::size_t i = 0; i < pairs; ++i)
      differences.push_back(std::abs(a[i * stride_a % a.size()] - b[i * stride_b % b.size()]));
    enough = median(differences);
    double sum = 0.0;
    for (const double d : differences) sum += std::min(d, enough);
    usual = sum / static_cast<double>(pairs);
  }

  /// Of a lag: negative where overlapping intervals are more alike than any, the more of them the farther.
  [[nodiscard]] double sum(std::span<const double> a, std::span<const double> b) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::min(std::abs(a[i] - b[i]), enough);
    return sum / usual - static_cast<double>(a.size());
  }
};

struct Candidate {
  double unlikeness;
  std::ptrdiff_t lag;  // intervals from a fixed one to the moved one beside it
};

std::vector<Candidate> candidates(std::span<const double> moved, std::span<const double> fixed) {
  const Unlikeness unlikeness(moved, fixed);
  if (!(unlikeness.usual > 0.0)) return {};
  const auto size = [](std::span<const double> angles) { return static_cast<std::ptrdiff_t>(angles.size()); };
  const auto least =
      static_cast<std::ptrdiff_t>(std::ceil(least_overlap * static_cast<double>(std::min(size(moved), size(fixed)))));
  std::vector<Candidate> all;
  for (std::ptrdiff_t lag = least - size(fixed); lag <= size(moved) - least; ++lag) {
    const auto from = std::max<std::ptrdiff_t>(0, -lag), to = std::min(size(fixed), size(moved) - lag);
    const auto count = static_cast<std::size_t>(to - from);
    all.push_back({unlikeness.sum(moved.subspan(static_cast<std::size_t>(from + lag), count),
                                  fixed.subspan(static_cast<std::size_t>(from), count)),
                   lag});
  }
  std::vector<Candidate> valleys;
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i == 0 || all[i].unlikeness <= all[i - 1].unlikeness) &&
        (i + 1 == all.size() || all[i].unlikeness <= all[i + 1].unlikeness))
      valleys.push_back(all[i]);
  std::ranges::stable_sort(valleys, {}, &Candidate::unlikeness);
  if (valleys.size() > most_candidates) valleys.resize(most_candidates);
  return valleys;
}

}  // namespace

std::vector<Eigen::Vector3d> turns_in_intervals(const AnyCurve& curve, double start, double length, std::size_t count) {
  std::vector<Eigen::Vector3d> turns;
  turns.reserve(count);
  Eigen::Quaterniond before = curve(start);
  for (std::size_t i = 1; i <= count; ++i) {
    const Eigen::Quaterniond now = curve(start + static_cast<double>(i) * length);
    turns.push_back(shortest_increment(before, now));
    before = now;
  }
  return turns;
}

std::vector<double> offsets_in_question(const AnyCurve& moved, const AnyCurve& fixed, double sampling_interval) {
  const double interval = interval_for(moved, fixed, sampling_interval);
  if (!(std::max(duration_of(moved), duration_of(fixed)) <= most_intervals * interval)) return {};
  const double start = moved.domain().start - fixed.domain().start;
  std::vector<double> offsets;
  for (const Candidate& candidate : candidates(angles_turned(moved, interval), angles_turned(fixed, interval)))
    offsets.push_back(start + static_cast<double>(candidate.lag) * interval);
  return offsets;
}

}}  // namespace orispline
