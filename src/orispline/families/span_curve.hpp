// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/curve/curve.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/track.hpp>

// Where a curve may move much farther than its keys say, and the curve there.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Two keys in a row, and a fast step near them.
struct SuspiciousSpan {
  std::size_t start, fast;  ///< the keys that it and the fast step begin with
  double ratio;             ///< of how far it would turn at that rate to how far its keys turn, and `turn` farther
};

/// Those whose ratio is above `least`, the worst first, a few at most. Takes a few nanoseconds a key.
[[nodiscard]] std::vector<SuspiciousSpan> suspicious_spans(const Keyframes& keys, double turn, double least);

/// The segment of a curve between two keys.
struct SpanCurve {
  AnyCurve curve;
  std::size_t segment;

  /// Orientation at a share of the time between its keys.
  [[nodiscard]] Eigen::Quaterniond at(double share) const {
    const KnotSpan knots = curve.knots().span(segment);
    return curve.orientation_on(segment, knots.start() + share * knots.step());
  }
};

/// That after the key `span` of the curve where it is at hand, which has a knot at every key; nothing in a gap.
[[nodiscard]] std::optional<SpanCurve> span_of(const AnyCurve& made, const Keyframes& keys, std::size_t span);

/// That of a curve through the keys around.
[[nodiscard]] std::optional<SpanCurve> span_of(const Method& method, const Keyframes& keys, std::size_t span);

/// `between the keys at 1 s and 2 s`
[[nodiscard]] std::string between_keys(const Track& track, std::size_t span);

}}  // namespace orispline
