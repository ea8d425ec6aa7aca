// SPDX-License-Identifier: Apache-2.0
#include "papers/frames.hpp"

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

FrameRow frames_of(std::string label, const std::function<Eigen::Quaterniond(double)>& motion,
                   std::span<const double> times, std::span<const double> key_times, const FrameColors& colors) {
  FrameRow row{std::move(label), {}};
  for (const double t : times) {
    const bool at_key = std::ranges::any_of(key_times, [t](double key) { return std::abs(t - key) < 1e-9; });
    row.frames.push_back({t, motion(t), at_key ? colors.key : colors.between});
  }
  return row;
}

FrameRow key_frames(std::string label, const Keyframes& keys, const FrameColors& colors) {
  constexpr std::size_t most = 17;
  const std::size_t shown = std::min(most, keys.size());
  FrameRow row{std::move(label), {}};
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t key = k * (keys.size() - 1) / (shown - 1);
    row.frames.push_back({keys.times()[key], keys.orientations()[key], colors.key});
  }
  return row;
}

std::string lettered(std::size_t row, const std::string& label) {
  return formatted("({}) {}", static_cast<char>('a' + row), label);
}

void draw_frames(report::Drawing& drawing, double top, std::span<const FrameRow> rows,
                 std::span<const report::Face> body) {
  constexpr double left = 205.0, right = 835.0, size = 23.0;
  const report::View view({1.0, -0.9, 0.8});
  double y = top + 0.5 * frame_row_height;
  for (const FrameRow& row : rows) {
    drawing.text({14.0, y + 4.0}, row.label, {report::Anchor::start});
    const double last = std::max(1.0, static_cast<double>(row.frames.size()) - 1.0);
    for (std::size_t k = 0; k < row.frames.size(); ++k)
      report::draw_body(drawing, view, {std::lerp(left, right, static_cast<double>(k) / last), y}, size,
                        row.frames[k].orientation, row.frames[k].color, body);
    y += frame_row_height;
  }
}

}  // namespace orispline::cli
