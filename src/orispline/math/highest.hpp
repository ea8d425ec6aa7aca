// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/base/expect.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a function is at a place.
struct Height {
  double place, value;
};

/// From a place that is not below two others around it up to where nothing rises: by golden section, to a millionth of
/// their distance, with which the value is out by its square.
template <class F>
[[nodiscard]] Height climbed(const F& f, double start, Height top, double end) {
  constexpr double part = 0.381966011250105, near_enough = 1e-6;
  const double shortest = near_enough * (end - start);
  while (end - start > shortest) {
    const bool is_left = top.place - start > end - top.place;
    const double place = top.place + part * ((is_left ? start : end) - top.place);
    if (place == top.place) break;
    const double value = f(place);
    const double other = value > top.value ? top.place : place;
    if (value > top.value) top = {place, value};
    (other < top.place ? start : end) = other;
  }
  return top;
}

/// The largest of a function that is nowhere negative, of which values at rising places are known: those that no
/// neighbour is above, and that are not far below the largest, or `known`, are climbed from.
template <class F>
[[nodiscard]] Height highest(std::span<const double> places, std::span<const double> values, const F& f,
                             double known = 0.0) {
  constexpr double worth_climbing = 0.8;
  ORISPLINE_EXPECT(!places.empty() && places.size() == values.size());
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
  Height best{places[largest], values[largest]};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t before = i - std::min<std::size_t>(i, 1), after = std::min(i + 1, places.size() - 1);
    if (!(values[i] >= worth_climbing * std::max(best.value, known)) || values[before] > values[i] ||
        values[after] > values[i] || (values[before] == values[i] && values[after] == values[i]))
      continue;
    const Height top = climbed(f, places[before], {places[i], values[i]}, places[after]);
    if (top.value > best.value) best = top;
  }
  return best;
}

/// The same of a function whose values come one after the other and are too many to be kept. Of the places that no
/// neighbour is above it keeps those above which the function may be largest: up to where the lines through the
/// neighbours go on, which no top goes beyond where the function bends downwards. Of many that may be, the highest few.
class SummitsInPassing {
 public:
  /// At a place beyond all before.
  void pass(Height height) {
    if (count_ > 0) note(last_, height);
    else best_.place = height.place;
    if (height.value > best_.value) best_ = height;
    before_ = count_ > 0 ? last_ : height;
    last_ = height;
    ++count_;
  }

  /// The largest at the places. Precondition: there was one.
  [[nodiscard]] const Height& highest_passed() const { return best_; }

  /// The largest, once all places have been passed; one that is not above `known` need not be found. Precondition:
  /// there was a place.
  template <class F>
  [[nodiscard]] Height highest(const F& f, double known = 0.0) {
    ORISPLINE_EXPECT(count_ > 0);
    if (count_ > 1) note(last_, last_);
    std::ranges::sort(summits_, std::ranges::greater(), &Summit::reach);
    for (const Summit& summit : summits_) {
      if (!(summit.reach > std::max(best_.value, known))) break;
      const Height top = climbed(f, summit.start, summit.top, summit.end);
      if (top.value > best_.value) best_ = top;
    }
    return best_;
  }

 private:
  static constexpr std::size_t most = 8;

  struct Summit {
    Height top;
    double start, end, reach;
  };

  /// A place between the one before it and the next; at either end there is but one of them.
  void note(const Height& here, const Height& next) {
    const double rise = here.value - before_.value, fall = here.value - next.value;
    if (rise < 0.0 || fall < 0.0 || (rise == 0.0 && fall == 0.0)) return;
    const double back = here.place - before_.place, on = next.place - here.place;
    const double above = back > 0.0 && on > 0.0 ? std::max(rise * on / back, fall * back / on) : std::max(rise, fall);
    if (!(here.value + above > best_.value)) return;
    if (summits_.size() == most) {
      std::erase_if(summits_, [&](const Summit& summit) { return !(summit.reach > best_.value); });
      if (summits_.size() == most) summits_.erase(std::ranges::min_element(summits_, {}, &Summit::reach));
    }
    summits_.push_back({here, before_.place, next.place, here.value + above});
  }

  Height best_{0.0, 0.0}, before_{}, last_{};
  std::size_t count_ = 0;
  std::vector<Summit> summits_{};
};

}}  // namespace orispline
