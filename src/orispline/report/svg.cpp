// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/svg.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

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
  for (const char c : text) switch (c) {
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
      parts_ += formatted("<polyline points=\"{}\" fill=\"none\"{}/>\n", listed({begin, end}), attributes(stroke));
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
