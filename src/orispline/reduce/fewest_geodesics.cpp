// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/fewest_geodesics.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/reduce/feasible_rates.hpp>
#include <orispline/reduce/span_check.hpp>
#include <orispline/reduce/span_reach.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Samples that no chain has reached yet, each with the first sample from which a span to it may begin.
class SpanTargets {
 public:
  explicit SpanTargets(const std::vector<std::size_t>& earliest) : leaves_(std::bit_ceil(earliest.size())) {
    earliest_.assign(2 * leaves_, none);
    std::copy(earliest.begin(), earliest.end(), earliest_.begin() + static_cast<std::ptrdiff_t>(leaves_));
    for (std::size_t node = leaves_; node-- > 1;) update(node);
  }

  /// The first one from sample k on to which a span from sample i may go; `none` where there is none.
  [[nodiscard]] std::size_t next(std::size_t i, std::size_t k) const {
    if (k >= leaves_) return none;
    std::size_t node = leaves_ + k;
    while (earliest_[node] > i) {
      while (node % 2 == 1) node /= 2;
      if (node == 0) return none;
      ++node;
    }
    while (node < leaves_) {
      node *= 2;
      if (earliest_[node] > i) ++node;
    }
    return node - leaves_;
  }
  void remove(std::size_t k) {
    earliest_[leaves_ + k] = none;
    for (std::size_t node = (leaves_ + k) / 2; node > 0; node /= 2) update(node);
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

 private:
  void update(std::size_t node) { earliest_[node] = std::min(earliest_[2 * node], earliest_[2 * node + 1]); }

  std::size_t leaves_;
  std::vector<std::size_t> earliest_;  ///< a tree of minima: node n has the children 2n and 2n + 1
};

/// How many spans a chain from a sample to the last one has at least. Later samples never have more.
class SpansToEnd {
 public:
  /// From the last sample that a span from each sample may reach.
  explicit SpansToEnd(std::vector<std::size_t> farthest);

  [[nodiscard]] std::size_t at_least(std::size_t sample) const { return spans_[sample]; }
  /// The first sample from which that many spans may be enough.
  [[nodiscard]] std::size_t first_within(std::size_t spans) const;

 private:
  std::vector<std::size_t> spans_;
};

SpansToEnd::SpansToEnd(std::vector<std::size_t> farthest) : spans_(farthest.size(), 0) {
  for (std::size_t i = 1; i < farthest.size(); ++i) farthest[i] = std::max(farthest[i], farthest[i - 1]);
  for (std::size_t i = farthest.size() - 1; i-- > 0;) spans_[i] = 1 + spans_[farthest[i]];
}

std::size_t SpansToEnd::first_within(std::size_t spans) const {
  const auto first = std::ranges::partition_point(spans_, [spans](std::size_t n) { return n > spans; });
  return static_cast<std::size_t>(first - spans_.begin());
}

class Chains {
 public:
  explicit Chains(const ToleranceCheck& recording)
      : recording_(recording),
        spans_(recording),
        telling_(spans_, recording.size()),
        farthest_(farthest_of_spans(recording, telling_, SpanDirection::to_end)),
        earliest_(farthest_of_spans(recording, telling_, SpanDirection::to_start)),
        to_end_(farthest_),
        targets_(earliest_),
        before_(recording.size(), 0),
        turns_(recording.size()),
        turned_from_(recording.size(), recording.size()),
        path_(recording.size(), 0.0) {
    for (std::size_t i = 1; i < path_.size(); ++i)
      path_[i] = path_[i - 1] + angular_distance(orientation(i - 1), orientation(i));
  }

  std::vector<std::size_t> shortest() {
    std::size_t more = 0;
    while (!is_found(to_end_.at_least(0) + more)) {
      if (recording_.stopped()) return {};
      more += 1 + more / 8;
    }
    std::vector<std::size_t> chain{recording_.size() - 1};
    while (chain.back() != 0) chain.push_back(before_[chain.back()]);
    return {chain.rbegin(), chain.rend()};
  }

 private:
  [[nodiscard]] double time(std::size_t i) const { return recording_.samples().times()[i]; }
  [[nodiscard]] Eigen::Quaterniond orientation(std::size_t i) const { return recording_.samples().orientations()[i]; }

  /// Whether the last sample is reached by a chain of not more than so many spans; then by the shortest of all.
  bool is_found(std::size_t spans) {
    keep_complete_levels(spans);
    while (levels_.size() <= spans && !levels_.back().empty()) {
      if (ends(levels_.back())) return true;
      const std::size_t first = to_end_.first_within(spans - levels_.size());
      std::vector<std::size_t> next;
      for (auto i = levels_.back().rbegin(); i != levels_.back().rend(); ++i) {
        if (recording_.stopped()) return false;
        extend(*i, first, next);
      }
      std::sort(next.begin(), next.end());
      levels_.push_back(std::move(next));
      first_.push_back(first);
    }
    return false;
  }

  /// Those that are the same where so many spans are allowed.
  void keep_complete_levels(std::size_t spans) {
    std::size_t complete = 1;
    while (complete < levels_.size() && (first_[complete] <= levels_[complete - 1].front() + 1 ||
                                         first_[complete] == to_end_.first_within(spans - complete)))
      ++complete;
    levels_.resize(complete);
    first_.resize(complete);
    targets_ = SpanTargets(earliest_);
    for (const auto& level : levels_)
      for (const std::size_t i : level) targets_.remove(i);
  }

  /// Whether a span holds from one of the samples to the last.
  bool ends(const std::vector<std::size_t>& level) {
    const std::size_t last = recording_.size() - 1;
    const auto holds = [&](std::size_t i) { return farthest_[i] == last && !spans_.violation(i, last, turn(i, last)); };
    const auto found = std::find_if(level.rbegin(), level.rend(), holds);
    if (found != level.rend()) before_[last] = *found;
    return found != level.rend();
  }

  /// The shorter way from sample i to sample k [rad].
  [[nodiscard]] const Eigen::Vector3d& turn(std::size_t i, std::size_t k) {
    if (std::exchange(turned_from_[k], i) == i) return turns_[k];
    return turns_[k] = shorter_turn(orientation(i), orientation(k));
  }

  /// To the rates from sample i that pass near sample k.
  void narrow(FeasibleRates& fan, std::size_t i, std::size_t k) {
    fan.narrow(turn(i, k), time(k) - time(i), recording_.tolerance().angle);
  }

  /// Reaches what can be reached from sample i, `first` or later, but not the last.
  void extend(std::size_t i, std::size_t first, std::vector<std::size_t>& reached) {
    FeasibleRates fan;
    std::size_t looked = i;
    const std::size_t end = std::min(farthest_[i] + 1, recording_.size() - 1);
    for (std::size_t j = targets_.next(i, std::max(first, i + 1)); j < end;) {
      for (std::size_t next = telling_.after(i, looked); next < j && !fan.is_empty();
           next = telling_.after(i, looked)) {
        looked = next;
        narrow(fan, i, looked);
      }
      if (fan.is_empty()) return;
      double lacking = fan.distance(turn(i, j) / (time(j) - time(i)));
      if (lacking <= 0.0) {
        if (const auto violation = spans_.violation(i, j, turn(i, j))) {
          lacking = violation->beyond / (time(violation->sample) - time(i));
          narrow(fan, i, violation->sample);
        } else {
          targets_.remove(j);
          before_[j] = i;
          reached.push_back(j);
        }
      }
      j = targets_.next(i, lacking > 0.0 ? next_worth_a_look(i, j, lacking) : j + 1);
    }
  }

  /// The first sample after j for which the mean rate from sample i may differ by `lacking` [rad/s] from that for j.
  [[nodiscard]] std::size_t next_worth_a_look(std::size_t i, std::size_t j, double lacking) const {
    constexpr double growth = 1.1107207345395916;  // of the logarithm up to a quarter turn: (π/4)/sin(π/4)
    constexpr double rounding = 1e-9;
    const double angle = turns_[j].norm(), elapsed = time(j) - time(i);
    std::size_t passed = j;
    for (std::size_t step = 1; j + step < recording_.size(); step *= 2) {
      const double path = path_[j + step] - path_[j], later = time(j + step) - time(i);
      const double change = growth * path / later + angle * (1.0 / elapsed - 1.0 / later);
      if (angle + path > 0.5 * std::numbers::pi || change * (1.0 + rounding) >= lacking) break;
      passed = j + step;
    }
    return passed + 1;
  }

  const ToleranceCheck& recording_;
  SpanTest spans_;
  WitnessSamples telling_;
  std::vector<std::size_t> farthest_;  ///< that a span from each sample may reach
  std::vector<std::size_t> earliest_;  ///< from which a span to each sample may begin
  SpansToEnd to_end_;
  SpanTargets targets_;
  std::vector<std::vector<std::size_t>> levels_{{0}};  ///< samples that chains of 0, 1, 2 … spans reach first
  std::vector<std::size_t> first_{0};                  ///< before which each level has none, for the end is too far
  std::vector<std::size_t> before_;                    ///< the sample before in the shortest chain
  std::vector<Eigen::Vector3d> turns_;                 ///< from the sample that was asked for last [rad]
  std::vector<std::size_t> turned_from_;               ///< that sample
  std::vector<double> path_;                           ///< angle travelled up to each sample [rad]
};

}  // namespace

std::vector<std::size_t> fewest_geodesics(const ToleranceCheck& recording) { return Chains(recording).shortest(); }

}}  // namespace orispline
