// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// The colours of the project's pictures: told apart by every eye and in print.
namespace color {
inline constexpr std::string_view ink = "#333333", grey = "#9a9a9a", blue = "#0072b2", red = "#d55e00",
                                  green = "#009e73", purple = "#b0579a", gold = "#c99a00", sky = "#56b4e9",
                                  grid = "#e4e4e4", frame = "#bbbbbb", white = "white", none = "none";
}  // namespace color

/// A place in a picture [px]: x to the right, y down.
struct Point {
  double x, y;
};

struct Box {
  double left, top, width, height;
};

struct Stroke {
  std::string_view color = color::ink;
  double width = 1.5;
  std::string_view dashes{};  ///< lengths as SVG takes them; empty: a solid line
};

struct Fill {
  std::string_view color = color::none;
  double opacity = 1.0;
};

enum class Anchor { start, middle, end };

struct Lettering {
  Anchor anchor = Anchor::middle;
  std::string_view color = color::ink;
  double size = 12.0;
};

/// Text with the characters replaced that XML would take for its own.
[[nodiscard]] ORISPLINE_EXPORT std::string escaped(std::string_view text);

/// A picture in the making, on white: what is drawn later lies on top.
///
/// Places that are not finite are not drawn: a line breaks there.
///
/// Of a line of many points those are left out without which it looks the same: it passes them at 0.1 px at most.
class ORISPLINE_EXPORT Drawing {
 public:
  Drawing(double width, double height) : width_(width), height_(height) {}

  void line(std::span<const Point> points, const Stroke& stroke = {});
  void polygon(std::span<const Point> corners, const Fill& fill, const Stroke& outline);
  void circle(Point center, double radius, const Fill& fill, const Stroke& outline);
  void text(Point at, std::string_view words, const Lettering& lettering = {});

  /// The whole SVG file.
  [[nodiscard]] std::string document() const;

 private:
  double width_, height_;
  std::string parts_;
};

}}}  // namespace orispline::report
