// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/svg.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

constexpr std::size_t few_points = 100;  // which stay as they are
constexpr double unseen = 0.1;           // [px] as coarse as places are written

Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
double length_of(Point p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// The directions from a point in which a straight line passes others, nearer ones, at no more than `unseen`.
class Cone {
 public:
  explicit Cone(Point apex) : apex_(apex) {}

  /// Whether a line to this point passes all that were seen before.
  [[nodiscard]] bool reaches(Point p) const {
    const Point d = p - apex_;
    const double length = length_of(d);
    return length >= farthest_ - unseen && (is_open_ || (cross(right_, d) >= 0.0 && cross(d, left_) >= 0.0));
  }

  void see(Point p) {
    const Point d = p - apex_;
    const double length = length_of(d);
    farthest_ = std::max(farthest_, length);
    if (length <= unseen) return;
    const double sine = unseen / length, cosine = std::sqrt(1.0 - sine * sine);
    const Point right{cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};
    const Point left{cosine * d.x - sine * d.y, cosine * d.y + sine * d.x};
    if (is_open_ || cross(right_, right) > 0.0) right_ = right;
    if (is_open_ || cross(left, left_) > 0.0) left_ = left;
    is_open_ = false;
  }

 private:
  Point apex_, right_{}, left_{};
  double farthest_ = 0.0;
  bool is_open_ = true;
};

/// Of many points those without which the line would be seen to be another one.
std::vector<Point> seen(std::span<const Point> points) {
  if (points.size() <= few_points) return {points.begin(), points.end()};
  std::vector<Point> kept{points.front()};
  Cone cone(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!cone.reaches(points[i])) {
      kept.push_back(points[i - 1]);
      cone = Cone(points[i - 1]);
    }
    cone.see(points[i]);
  }
  kept.push_back(points.back());
  return kept;
}

std::string listed(std::span<const Point> points) {
  std::string list;
  for (const Point p : points)
    fmt::format_to(std::back_inserter(list), "{}{:.1f},{:.1f}", list.empty() ? "" : " ", p.x, p.y);
  return list;
}

std::string attributes(const Stroke& stroke) {
  std::string text = formatted(R"( stroke="{}" stroke-width="{:g}")", escaped(stroke.color), stroke.width);
  if (!stroke.dashes.empty()) text += formatted(R"( stroke-dasharray="{}")", escaped(stroke.dashes));
  return text;
}

std::string attributes(const Fill& fill) {
  std::string text = formatted(R"( fill="{}")", escaped(fill.color));
  if (fill.opacity < 1.0) text += formatted(R"( fill-opacity="{:g}")", fill.opacity);
  return text;
}

constexpr std::array anchor_names{"start", "middle", "end"};

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text_of_unicode(text)) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

void Drawing::line(std::span<const Point> points, const Stroke& stroke) {
  for (auto begin = points.begin(); begin != points.end();) {
    begin = std::find_if(begin, points.end(), is_finite);
    const auto end = std::find_if_not(begin, points.end(), is_finite);
    if (end - begin > 1)
      parts_ +=
          formatted("<polyline points=\"{}\" fill=\"none\"{}/>\n", listed(seen({begin, end})), attributes(stroke));
    begin = end;
  }
}

void Drawing::polygon(std::span<const Point> corners, const Fill& fill, const Stroke& outline) {
  if (!std::ranges::all_of(corners, is_finite)) return;
  parts_ += formatted("<polygon points=\"{}\"{}{}/>\n", listed(corners), attributes(fill), attributes(outline));
}

void Drawing::circle(Point center, double radius, const Fill& fill, const Stroke& outline) {
  if (!is_finite(center)) return;
  parts_ += formatted("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\"{}{}/>\n", center.x, center.y, radius,
                      attributes(fill), attributes(outline));
}

void Drawing::text(Point at, std::string_view words, const Lettering& lettering) {
  if (!is_finite(at)) return;
  parts_ += formatted(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}" fill="{}" font-size="{:g}">{}</text>)", at.x,
                      at.y, anchor_names[static_cast<std::size_t>(lettering.anchor)], escaped(lettering.color),
                      lettering.size, escaped(words)) +
            "\n";
}

std::string Drawing::document() const {
  return formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" "
      "font-family=\"sans-serif\" stroke-linejoin=\"round\">\n"
      "<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"white\"/>\n{2}</svg>\n",
      width_, height_, parts_);
}

}}}  // namespace orispline::report
