// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <orispline/analysis/continuity.hpp>

// The places where segments of a curve meet, with the rates on both sides.

namespace orispline { inline namespace ORISPLINE_ABI {

/// Where two segments meet.
struct Joint {
  std::size_t key;
  double spacing;  // the smaller one beside it [s]
  Motion left, right;
};

/// Calls `look` for every interior key and, of a loop, for its seam (key 0).
template <class Look>
void for_each_joint(const AnyCurve& curve, Seam seam, Look&& look) {
  const auto t = curve.knots().times();
  for (std::size_t i = 1; i + 1 < t.size(); ++i)
    look(Joint{i, std::min(t[i] - t[i - 1], t[i + 1] - t[i]), curve.motion(t[i], Side::left),
               curve.motion(t[i], Side::right)});
  if (seam == Seam::open || t.size() < 2) return;
  const std::size_t last = t.size() - 1;
  look(Joint{0, std::min(t[1] - t[0], t[last] - t[last - 1]), curve.motion(t[last]), curve.motion(t[0])});
}

/// Calls `look` with motions that show how fast the curve is: at its ends and at three points of each segment.
template <class Look>
void for_each_probe(const AnyCurve& curve, Look&& look) {
  const auto t = curve.knots().times();
  look(curve.motion(t.front()));
  look(curve.motion(t.back()));
  for (std::size_t i = 0; i + 1 < t.size(); ++i)
    for (const double u : {0.25, 0.5, 0.75}) look(curve.motion(std::lerp(t[i], t[i + 1], u)));
}

}}  // namespace orispline
