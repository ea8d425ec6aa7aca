// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <orispline/base/expect.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// At a knot two segments meet: which of them is meant.
enum class Side { right, left };

/// One interval between knots: t[i] ≤ time ≤ t[i+1].
struct KnotSpan {
  std::span<const double> t;
  std::size_t i;
  double before_first, after_last;  ///< h beyond the ends [s]

  [[nodiscard]] double start() const noexcept { return t[i]; }
  [[nodiscard]] double end() const noexcept { return t[i + 1]; }
  /// h of this interval [s].
  [[nodiscard]] double step() const noexcept { return t[i + 1] - t[i]; }
  /// h of the interval before; at the first one that to the ghost key.
  [[nodiscard]] double previous_step() const noexcept { return i > 0 ? t[i] - t[i - 1] : before_first; }
  /// h of the interval after; at the last one that to the ghost key.
  [[nodiscard]] double next_step() const noexcept { return i + 2 < t.size() ? t[i + 2] - t[i + 1] : after_last; }

  /// The local parameter u in [0, 1]; exactly 0 and 1 at the two knots.
  template <Number T>
  [[nodiscard]] T normalised(const T& time) const noexcept {
    return (time - T(start())) / step();
  }
};

/// Strictly increasing times [s] that cut a curve into segments.
class Knots {
 public:
  /// At least one time; finite, strictly increasing. Ghost keys stand at the mirrored distance beyond the ends.
  explicit Knots(std::vector<double> t) : t_(std::move(t)) {
    ORISPLINE_EXPECT(!t_.empty() && t_.size() <= std::numeric_limits<std::uint32_t>::max());
    if (segments() == 0) return;
    before_first_ = t_[1] - t_[0];
    after_last_ = t_[segments()] - t_[segments() - 1];
    if (t_.size() > 2) fill_slots();
  }

  /// The knots of a loop: at least two times, the last being the first again; the steps beyond the ends wrap around.
  [[nodiscard]] static Knots closed(std::vector<double> t) {
    Knots knots(std::move(t));
    std::swap(knots.before_first_, knots.after_last_);
    return knots;
  }

  [[nodiscard]] std::span<const double> times() const noexcept { return t_; }
  [[nodiscard]] std::size_t segments() const noexcept { return t_.size() - 1; }
  [[nodiscard]] double front() const noexcept { return t_.front(); }
  [[nodiscard]] double back() const noexcept { return t_.back(); }
  [[nodiscard]] KnotSpan span(std::size_t i) const noexcept { return {t_, i, before_first_, after_last_}; }

  /// Index of the segment that holds `time`: at an interior knot the right-hand one or, on request, the left-hand one.
  /// Outside the domain the first or the last.
  [[nodiscard]] std::size_t segment_at(double time, Side side = Side::right) const noexcept {
    if (t_.size() < 3) return 0;
    return side == Side::right ? inner_knots_that([time](double knot) { return knot <= time; }, time)
                               : inner_knots_that([time](double knot) { return knot < time; }, time);
  }

 private:
  /// The domain is cut into as many even slots as there are segments; a time's slot says nearly where it belongs.
  [[nodiscard]] std::size_t slot_of(double time) const noexcept {
    const double place = (time - front()) * slots_per_second_;
    return place > 0.0 ? static_cast<std::size_t>(std::min(place, static_cast<double>(segments() - 1))) : 0;
  }

  void fill_slots() {
    slots_per_second_ = static_cast<double>(segments()) / (back() - front());
    knots_before_slot_.assign(segments() + 1, 0);
    for (std::size_t i = 1; i < segments(); ++i) ++knots_before_slot_[slot_of(t_[i]) + 1];
    for (std::size_t i = 1; i < knots_before_slot_.size(); ++i) knots_before_slot_[i] += knots_before_slot_[i - 1];
  }

  /// How many inner knots are passed at `time`; `passed` is true for those up to it.
  template <class Passed>
  [[nodiscard]] std::size_t inner_knots_that(Passed passed, double time) const noexcept {
    const std::size_t slot = slot_of(time);
    std::size_t known = knots_before_slot_[slot], open = knots_before_slot_[slot + 1] - known;
    while (open > 0) {
      const std::size_t half = open / 2;
      const bool beyond = passed(t_[1 + known + half]);
      known = beyond ? known + half + 1 : known;
      open = beyond ? open - half - 1 : half;
    }
    return known;
  }

  std::vector<double> t_;
  double before_first_ = 0.0, after_last_ = 0.0;
  double slots_per_second_ = 0.0;
  std::vector<std::uint32_t> knots_before_slot_;  ///< inner knots in earlier slots; at the end all of them
};

}}  // namespace orispline
