// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <orispline/curve/own_family.hpp>
#include <orispline/families/blending/expression.hpp>

// What rows of expressions depend on where two segments meet.

namespace orispline { inline namespace ORISPLINE_ABI { namespace blending {

/// Values of all quantities around a joint. Segment 0 lies before key 1, segment 1 behind it.
template <class Value>
struct Surroundings {
  std::vector<Value> parameters;                 ///< the same at all keys
  std::map<std::pair<int, int>, Value> at_keys;  ///< by parameter and key, where they are not
  std::map<int, Value> lengths;                  ///< by interval, where they are not 1
};

/// The field of a segment.
template <class Value>
struct SegmentField {
  const Surroundings<Value>& around;
  int segment;

  [[nodiscard]] Value constant(const Literal& literal) const { return literal.in<Value>(); }
  [[nodiscard]] Value quantity(const Quantity& q) const {
    const int place = q.offset + segment;
    if (q.kind == Quantity::Kind::length) {
      const auto found = around.lengths.find(place);
      return found == around.lengths.end() ? constant(whole(1)) : found->second;
    }
    const auto found = around.at_keys.find({q.parameter, place});
    return found == around.at_keys.end() ? around.parameters[static_cast<std::size_t>(q.parameter)] : found->second;
  }
  [[nodiscard]] Value length(int interval) const { return quantity({Quantity::Kind::length, 0, interval - segment}); }
};

inline constexpr int farthest_place = 18;  // a coefficient reaches 8 keys, and increments 4

/// Numbers as good as random, always the same.
class Sequence {
 public:
  Modular next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return Modular(state_ >> 2);
  }
  /// From 0 to 1.
  double share() {
    next();
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 0x853c49e6748fea9bu;
};

enum class Times { even, uneven };

/// `parameter(p, place)` at every key, `length()` of every interval, or once of all.
template <class Value, class Parameter, class Length>
Surroundings<Value> surroundings(const BlendingData& data, Times times, Parameter&& parameter, Length&& length) {
  Surroundings<Value> around;
  const Value step = length();
  for (int place = -farthest_place; place <= farthest_place; ++place) {
    for (std::size_t p = 0; p < data.parameters.size(); ++p)
      around.at_keys[{static_cast<int>(p), place}] = parameter(p, place);
    around.lengths[place] = times == Times::even ? step : length();
  }
  return around;
}

/// Parameters of their own at every key; lengths of their own, or all the same.
inline Surroundings<Modular> generic(const BlendingData& data, Times times) {
  Sequence random;
  return surroundings<Modular>(
      data, times, [&](std::size_t, int) { return random.next(); }, [&] { return random.next(); });
}

}}}  // namespace orispline::blending
