// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/report/svg.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

struct Range {
  double low, high;
  [[nodiscard]] double extent() const noexcept { return high - low; }
};

/// The smallest range of the finite values; [0, 1] where there are none.
[[nodiscard]] ORISPLINE_EXPORT Range range_of(std::span<const double> values);

/// A little wider at both ends, where the range has no extent by 1.
[[nodiscard]] ORISPLINE_EXPORT Range with_margin(Range range);

/// Multiples of 1, 2 or 5 times a power of ten in a finite range with an extent: at most 8 of them.
[[nodiscard]] ORISPLINE_EXPORT std::vector<double> round_values(Range range);

/// One curve of a chart. Where y is not finite the curve breaks.
struct Series {
  std::string label;
  std::vector<double> x, y;  ///< as many of each
  Stroke stroke{};
};

/// Values that belong to a place on the horizontal axis, such as the keys.
struct Mark {
  double x;
  std::string label{};
};

/// Curves over one horizontal axis.
struct Chart {
  std::string title;  ///< what the vertical axis shows, and its unit
  std::vector<Series> series;
  std::vector<Mark> marks{};  ///< upright lines; where none has a label, round values of x stand below
  std::optional<Range> y{};   ///< absent: from the series and 0, with a margin
  std::string x_unit{};       ///< behind the round values of x
};

/// Draws the chart; the box is that of the curves, titles and numbers stand around it.
ORISPLINE_EXPORT void draw(Drawing& drawing, const Box& box, const Chart& chart);

/// How far it is in a legend from the start of one label to that of the next, and from one line to the next [px].
[[nodiscard]] ORISPLINE_EXPORT double legend_pitch(std::string_view label);
inline constexpr double legend_line = 18.0;

/// The labels of the series in a row from `at` to the right; a label that another series had before is left out. One
/// may have several lines.
ORISPLINE_EXPORT void draw_legend(Drawing& drawing, Point at, std::span<const Series> series);

}}}  // namespace orispline::report
