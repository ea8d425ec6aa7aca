// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/chart.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include <orispline/base/decimal.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/report/characters.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

/// From values to places in the box.
struct Axes {
  Box box;
  Range x, y;

  [[nodiscard]] Point at(double value_x, double value_y) const {
    return {box.left + box.width * (value_x - x.low) / x.extent(),
            box.top + box.height * (y.high - value_y) / y.extent()};
  }
  [[nodiscard]] double bottom() const { return box.top + box.height; }
  [[nodiscard]] double right() const { return box.left + box.width; }
};

Range united(Range a, Range b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Range range_of_y(const Chart& chart) {
  Range all{0.0, 0.0};
  for (const Series& series : chart.series)
    if (std::ranges::any_of(series.y, [](double v) { return std::isfinite(v); })) all = united(all, range_of(series.y));
  const Range wide = with_margin(all);
  return {all.low == 0.0 ? 0.0 : wide.low, all.high == 0.0 && all.low < 0.0 ? 0.0 : wide.high};
}

Range range_of_x(const Chart& chart) {
  std::vector<double> ends;
  for (const Series& series : chart.series) {
    const Range range = range_of(series.x);
    ends.insert(ends.end(), {range.low, range.high});
  }
  const Range all = range_of(ends);
  return all.extent() > 0.0 ? all : with_margin(all);
}

void draw_grid(Drawing& drawing, const Axes& axes, const Chart& chart) {
  for (const double value : round_values(axes.y)) {
    const double y = axes.at(axes.x.low, value).y;
    drawing.line(std::array{Point{axes.box.left, y}, Point{axes.right(), y}}, {color::grid, 1.0});
    drawing.text({axes.box.left - 6.0, y + 4.0}, formatted("{:g}", value), {Anchor::end});
  }
  for (const Mark& mark : chart.marks) {
    const double x = axes.at(mark.x, 0.0).x;
    drawing.line(std::array{Point{x, axes.box.top}, Point{x, axes.bottom()}}, {color::frame, 1.0, "3 3"});
    drawing.text({x, axes.bottom() + 16.0}, mark.label);
  }
  if (std::ranges::any_of(chart.marks, [](const Mark& mark) { return !mark.label.empty(); })) return;
  for (const double value : round_values(axes.x))
    drawing.text({axes.at(value, 0.0).x, axes.bottom() + 16.0}, formatted("{:g}{}", value, chart.x_unit));
}

/// Values outside the range are left out.
std::vector<Point> places(const Axes& axes, const Series& series) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const bool inside = series.y[i] >= axes.y.low && series.y[i] <= axes.y.high;
    points.push_back(axes.at(series.x[i], inside ? series.y[i] : std::numeric_limits<double>::quiet_NaN()));
  }
  return points;
}

}  // namespace

Range range_of(std::span<const double> values) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double v : values)
    if (std::isfinite(v)) range = united(range, {v, v});
  return range.low <= range.high ? range : Range{0.0, 1.0};
}

Range with_margin(Range range) {
  const double margin = range.extent() > 0.0 ? 0.05 * range.extent() : 1.0;
  return {range.low - margin, range.high + margin};
}

std::vector<double> round_values(Range range) {
  const double third = std::min(range.extent(), std::numeric_limits<double>::max()) / 3.0;
  const double power = Decimal::power_of_ten(Decimal::from_double(third).decade()).to_double();
  double step = power;
  for (const double k : {2.0, 5.0})
    if (range.extent() / (k * power) >= 3.0) step = k * power;
  std::vector<double> values;
  const double slack = 1e-9;  // an end that is a multiple itself belongs to the range
  for (double k = std::ceil(range.low / step - slack); k <= std::floor(range.high / step + slack); k += 1.0)
    values.push_back(k == 0.0 ? 0.0 : k * step);
  return values;
}

void draw(Drawing& drawing, const Box& box, const Chart& chart) {
  const Axes axes{box, range_of_x(chart), chart.y ? *chart.y : range_of_y(chart)};
  drawing.text({box.left, box.top - 7.0}, chart.title, {Anchor::start});
  draw_grid(drawing, axes, chart);
  for (const Series& series : chart.series) drawing.line(places(axes, series), series.stroke);
}

double legend_pitch(std::string_view label) { return 50.0 + 7.2 * static_cast<double>(characters(label)); }

void draw_legend(Drawing& drawing, Point at, std::span<const Series> series) {
  std::set<std::string_view> shown;
  for (const Series& s : series) {
    if (s.label.empty() || !shown.insert(s.label).second) continue;
    drawing.line(std::array{at, Point{at.x + 22.0, at.y}}, {s.stroke.color, 3.0, s.stroke.dashes});
    Point words{at.x + 28.0, at.y + 4.0};
    for (const std::string_view line : pieces_of(s.label, '\n')) {
      drawing.text(words, line, {Anchor::start, s.stroke.color});
      words.y += legend_line;
    }
    at.x += legend_pitch(s.label);
  }
}

}}}  // namespace orispline::report
