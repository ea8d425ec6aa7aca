// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/span_reach.hpp>

#include <algorithm>
#include <bit>

#include <orispline/reduce/feasible_rates.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t steps_for_one_proof = 32;  // it is sought anew for every 32nd of its span: closer, but slower

/// No span from place `from` reaches `barred`, for it would have to pass `passed` too; `passed` = `from` means that
/// more than these two are needed for the proof.
struct Barrier {
  std::size_t from, passed, barred;
};

/// Places count the samples in the direction of the spans.
class Reach {
 public:
  Reach(const ToleranceCheck& recording, const WitnessSamples& telling, SpanDirection direction)
      : recording_(recording), telling_(telling), direction_(direction) {}

  [[nodiscard]] std::size_t sample(std::size_t place) const {
    return direction_ == SpanDirection::to_end ? place : size() - 1 - place;
  }
  [[nodiscard]] Barrier barrier(std::size_t i) const;
  /// Whether the barrier is one for place i as well, and not needlessly far.
  [[nodiscard]] bool still_holds(const Barrier& barrier, std::size_t i) const;

 private:
  [[nodiscard]] std::size_t size() const { return recording_.size(); }
  [[nodiscard]] std::size_t looked_after(std::size_t i, std::size_t looked) const {
    return direction_ == SpanDirection::to_end ? telling_.after(i, looked)
                                               : sample(telling_.before(sample(i), sample(looked)));
  }
  [[nodiscard]] std::size_t passed_before(std::size_t i, std::size_t barred) const;

  const ToleranceCheck& recording_;
  const WitnessSamples& telling_;
  SpanDirection direction_;
};

Barrier Reach::barrier(std::size_t i) const {
  FeasibleRates fan;
  std::size_t passed = i, barred = size();
  while (barred - passed > 1) {
    const std::size_t k = barred < size() ? passed + (barred - passed) / 2 : looked_after(i, passed);
    FeasibleRates narrower = fan;
    narrower.narrow(recording_, sample(i), sample(k));
    if (narrower.is_empty()) barred = k;
    else fan = narrower, passed = k;
  }
  return {i, barred < size() ? passed_before(i, barred) : i, barred};
}

std::size_t Reach::passed_before(std::size_t i, std::size_t barred) const {
  FeasibleRates fan;
  fan.narrow(recording_, sample(i), sample(barred));
  for (std::size_t k = i + 1; k < barred; k = looked_after(i, k)) {
    FeasibleRates both = fan;
    both.narrow(recording_, sample(i), sample(k));
    if (both.is_empty()) return k;
  }
  return i;
}

bool Reach::still_holds(const Barrier& barrier, std::size_t i) const {
  if ((barrier.from - i) * steps_for_one_proof > barrier.barred - i) return false;
  if (barrier.barred == size()) return true;
  if (barrier.passed == barrier.from) return false;
  FeasibleRates fan;
  fan.narrow(recording_, sample(i), sample(barrier.passed));
  fan.narrow(recording_, sample(i), sample(barrier.barred));
  return fan.is_empty();
}

}  // namespace

WitnessSamples::WitnessSamples(const SpanTest& spans, std::size_t size) : size_(size) {
  for (std::size_t intervals = 2; intervals < size; intervals *= 2) {
    std::vector<std::size_t> level;
    for (std::size_t first = 0; first + intervals < size; first += intervals) {
      const std::vector<std::size_t> samples = spans.farthest_from_block(first, intervals, 4);
      level.insert(level.end(), samples.begin(), samples.end());
    }
    std::ranges::sort(level);
    levels_.push_back(std::move(level));
  }
}

const std::vector<std::size_t>* WitnessSamples::at_distance(std::size_t distance) const {
  const auto width = static_cast<std::size_t>(std::bit_width(distance));
  return width < 4 || levels_.empty() ? nullptr : &levels_[std::min(width - 4, levels_.size() - 1)];
}

std::size_t WitnessSamples::after(std::size_t i, std::size_t looked) const {
  const auto* samples = at_distance(looked - i);
  if (!samples) return std::min(looked + 1, size_ - 1);
  const auto next = std::ranges::upper_bound(*samples, looked);
  return next == samples->end() ? size_ - 1 : *next;
}

std::size_t WitnessSamples::before(std::size_t i, std::size_t looked) const {
  const auto* samples = at_distance(i - looked);
  if (!samples) return std::max<std::size_t>(looked, 1) - 1;
  const auto next = std::ranges::lower_bound(*samples, looked);
  return next == samples->begin() ? 0 : *(next - 1);
}

std::vector<std::size_t> farthest_of_spans(const ToleranceCheck& recording, const WitnessSamples& telling,
                                           SpanDirection direction) {
  const Reach reach(recording, telling, direction);
  const std::size_t last = recording.size() - 1;
  std::vector<std::size_t> farthest(recording.size(), reach.sample(last));
  Barrier found{last, last, last + 1};
  for (std::size_t i = last; i-- > 0 && !recording.stopped();) {
    if (!reach.still_holds(found, i)) found = reach.barrier(i);
    farthest[reach.sample(i)] = reach.sample(std::max(found.barred - 1, i + 1));
  }
  return farthest;
}

}}  // namespace orispline
