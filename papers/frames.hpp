// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/report/sphere.hpp>

namespace orispline::cli {

/// One body of a row.
struct Frame {
  double t;  ///< [s]
  Eigen::Quaterniond orientation;
  std::string_view color;
};

/// A motion as bodies side by side.
struct FrameRow {
  std::string label;
  std::vector<Frame> frames;
};

/// What is painted how in a row.
struct FrameColors {
  std::string_view key, between;
};

/// A motion's orientations at these times [s], those at a key's time in the colour of keys.
[[nodiscard]] FrameRow frames_of(std::string label, const std::function<Eigen::Quaterniond(double)>& motion,
                                 std::span<const double> times, std::span<const double> key_times,
                                 const FrameColors& colors);

/// The keys alone, at most as many as a row of a motion has, evenly picked.
[[nodiscard]] FrameRow key_frames(std::string label, const Keyframes& keys, const FrameColors& colors);

/// `(c) LABEL` of the third row, which is number 2.
[[nodiscard]] std::string lettered(std::size_t row, const std::string& label);

inline constexpr double frame_row_height = 66.0;  // [px]

/// Draws rows from `top` down across a drawing 860 px wide, as if each body moved along a straight line.
void draw_frames(report::Drawing& drawing, double top, std::span<const FrameRow> rows,
                 std::span<const report::Face> body = report::aircraft());

}  // namespace orispline::cli
