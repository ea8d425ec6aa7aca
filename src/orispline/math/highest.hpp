// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

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

}}  // namespace orispline
