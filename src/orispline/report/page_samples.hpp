// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

[[nodiscard]] ORISPLINE_EXPORT PageKeys page_keys(const Keyframes& keys);

/// Writes the motions of a segment at a few of its times [s].
using SegmentLook = std::function<void(std::size_t segment, std::span<const double> times, std::span<Motion> motions)>;

/// The curve at about `count` times, at least both ends of every segment: a time at a key stands twice, first with the
/// rates on its left, then with those on its right, so that their jumps are seen.
///
/// Of a curve with more than `count` / 4 segments, in `count` / 9 columns of equal width, those samples of each where
/// the rates and the angle from the start are the least and the largest, so that no peak is missed, and one in a gap:
/// at most ten a column. `count` is at least 2. Of a constant curve, one sample. `look`: how the curve is looked at to
/// find these, where that is faster than motion by motion.
[[nodiscard]] ORISPLINE_EXPORT PageSamples sampled(const PoseCurve& curve, std::size_t count = 600,
                                                   const SegmentLook& look = {});

/// Angles [deg] to the reference, which goes the shortest way between its orientations; NaN beyond its ends.
[[nodiscard]] ORISPLINE_EXPORT std::vector<double> errors_to(const PagePath& reference, const PagePath& path);

/// Angles [deg] at rising times.
struct PageErrors {
  std::vector<double> times{};  ///< [s]
  std::vector<double> values{};
};

/// At most `count` of the errors: the largest of every so many neighbours, so that none is missed. None of them is NaN.
[[nodiscard]] ORISPLINE_EXPORT PageErrors largest(const PageErrors& errors, std::size_t count);

/// Whether there is a motion at a time [s]; not in a gap.
using Covers = std::function<bool(double)>;
/// The curve with NaN for its orientations and rates in gaps.
[[nodiscard]] ORISPLINE_EXPORT PageSamples with_gaps(PageSamples samples, const Covers& covers);
/// The orientations with one of NaN between neighbours that a gap is between.
[[nodiscard]] ORISPLINE_EXPORT PagePath with_gaps(const PagePath& path, const Covers& covers);
/// The errors with a NaN likewise.
[[nodiscard]] ORISPLINE_EXPORT PageErrors with_gaps(const PageErrors& errors, const Covers& covers);

/// At most about `count` of the orientations, evenly picked, with both ends.
[[nodiscard]] ORISPLINE_EXPORT PagePath thinned(const PagePath& path, std::size_t count = 600);
/// Of the keys likewise.
[[nodiscard]] ORISPLINE_EXPORT PageKeys thinned(const PageKeys& keys, std::size_t count);

}}}  // namespace orispline::report
