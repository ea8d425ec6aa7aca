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

/// Whether there is a motion at a time [s]; not in a gap.
using Covers = std::function<bool(double)>;

/// How finely a curve is sampled for what the page draws between its samples.
struct Fineness {
  double angle = 0.005;     ///< [deg], within which the drawing is of the curve, where `most` samples can
  std::size_t least = 600;  ///< samples for smooth lines of rates; fewer where straight lines show these
  std::size_t most = 5000;  ///< samples
  Covers covers{};          ///< the segments with a motion, by their middles; absent: all
};

/// Samples between which the page draws the curve within the angle, and positions within a 2000th of what they take up,
/// or as near as `most` samples come; `exactness` is the angle that was found. In each gap there is one of NaN.
///
/// Of a curve with up to `least` / 4 segments at least `least` even times, and both sides of the knots where a rate
/// jumps by more than a thousandth of its largest. Of others few where the curve is smooth, and all together up to
/// `least` or a quarter more than the angle takes where the lines of rates are farthest from straight ones, so that no
/// peak is missed.
[[nodiscard]] ORISPLINE_EXPORT PageSamples drawn_samples(const PoseCurve& curve, const Fineness& fineness = {});

/// Angles [deg] at rising times.
struct PageErrors {
  std::vector<double> times{};  ///< [s]
  std::vector<double> values{};
};

/// At most `count` of the errors: the largest of every so many neighbours, so that none is missed. None of them is NaN.
[[nodiscard]] ORISPLINE_EXPORT PageErrors largest(const PageErrors& errors, std::size_t count);

/// The errors at these places, which rise, each the largest of those that are nearest to it, so that none is missed. A
/// NaN stands only where all of these are.
[[nodiscard]] ORISPLINE_EXPORT PageErrors largest_near(const PageErrors& errors, std::span<const std::size_t> places);

/// The orientations with one of NaN between neighbours that a gap is between.
[[nodiscard]] ORISPLINE_EXPORT PagePath with_gaps(const PagePath& path, const Covers& covers);
/// The errors with a NaN in the same places.
[[nodiscard]] ORISPLINE_EXPORT PageErrors with_gaps(const PageErrors& errors, const Covers& covers);

/// At most about `count` of the orientations, evenly picked, with both ends.
[[nodiscard]] ORISPLINE_EXPORT PagePath thinned(const PagePath& path, std::size_t count = 600);
/// At most about `count` of the keys, picked in the same way.
[[nodiscard]] ORISPLINE_EXPORT PageKeys thinned(const PageKeys& keys, std::size_t count);

}}}  // namespace orispline::report
