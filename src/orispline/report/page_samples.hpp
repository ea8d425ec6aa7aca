// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/pose_curve.hpp>
#include <orispline/report/page.hpp>

namespace orispline::report {

[[nodiscard]] PageKeys page_keys(const Keyframes& keys);

/// The curve at about `count` times, at least both ends of every segment: a time at a key stands twice, first with the
/// rates on its left, then with those on its right, so that their jumps are seen.
///
/// Of a curve with more than `count` / 4 segments, at `count` even times instead. `count` is at least 2. Of a constant
/// curve, one sample.
[[nodiscard]] PageSamples sampled(const PoseCurve& curve, std::size_t count = 600);

/// Angles [deg] to the reference, which goes the shortest way between its orientations; NaN beyond its ends.
[[nodiscard]] std::vector<double> errors_to(const PagePath& reference, const PagePath& path);

/// At most about `count` of the orientations, evenly picked, with both ends.
[[nodiscard]] PagePath thinned(const PagePath& path, std::size_t count = 600);

}  // namespace orispline::report
