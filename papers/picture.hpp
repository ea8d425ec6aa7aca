// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <orispline/report/chart.hpp>
#include <orispline/report/sphere.hpp>

#include "papers/frames.hpp"

namespace orispline::cli {

/// A picture of an experiment. It keeps the curves that are drawn in it as numbers, for whoever draws them again.
class Picture {
 public:
  Picture(std::string name, double width, double height) : drawing(width, height), name_(std::move(name)) {}

  void add(const report::Box& box, report::Chart chart);
  void add(const report::View& view, report::Point center, double radius, report::SpherePicture sphere);
  void add_frames(double top, std::vector<FrameRow> rows, std::span<const report::Face> body = report::aircraft());
  /// Curves that the caller has drawn.
  void keep(report::Chart chart) { charts_.push_back(std::move(chart)); }

  [[nodiscard]] const std::string& name() const { return name_; }  ///< of its file, without the extension
  [[nodiscard]] std::span<const report::Chart> charts() const { return charts_; }
  [[nodiscard]] std::span<const report::SpherePicture> spheres() const { return spheres_; }
  [[nodiscard]] std::span<const FrameRow> rows() const { return rows_; }

  report::Drawing drawing;

 private:
  std::string name_;
  std::vector<report::Chart> charts_;
  std::vector<report::SpherePicture> spheres_;
  std::vector<FrameRow> rows_;
};

}  // namespace orispline::cli
