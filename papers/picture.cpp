// SPDX-License-Identifier: Apache-2.0
#include "papers/picture.hpp"

#include <algorithm>
#include <iterator>

namespace orispline::cli {

void Picture::add(const report::Box& box, report::Chart chart) {
  report::draw(drawing, box, chart);
  keep(std::move(chart));
}

void Picture::add(const report::View& view, report::Point center, double radius, report::SpherePicture sphere) {
  report::draw(drawing, view, center, radius, sphere);
  spheres_.push_back(std::move(sphere));
}

void Picture::add_frames(double top, std::vector<FrameRow> rows, std::span<const report::Face> body) {
  draw_frames(drawing, top, rows, body);
  std::ranges::move(rows, std::back_inserter(rows_));
}

}  // namespace orispline::cli
