// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/curve/pose_curve.hpp>
#include <orispline/retime/path_hull.hpp>
#include <orispline/retime/rate_bounds.hpp>
#include <orispline/retime/segment_hull.hpp>

// What a motion is at a time, and what it is nowhere above around that time: for orientations and for positions.

namespace orispline { inline namespace ORISPLINE_ABI {

/// A part of a segment in its two units.
struct Stretch {
  double middle, radius;  ///< [s]
  double start, end;      ///< of u in [0, 1]
};

/// Turning on one segment: quantities at a time, and bounds of them around it.
class Turning {
 public:
  Turning(const AnyCurve& curve, std::size_t segment, const SegmentHull& hull, const MotionQuantities& quantities);

  void go_to(double t) { m_ = curve_.motion_on(segment_, t); }
  /// Of quantity k; 0 for one of positions.
  [[nodiscard]] double size(std::size_t k) const;
  /// Of all times in the part, in whose middle the motion is.
  [[nodiscard]] QuantitySizes bounds(const Stretch& part) const;
  /// Adds what the rounding of the keys makes of the shortest step near the segment [s].
  void round(SegmentPeaks& peaks, double shortest) const;

 private:
  [[nodiscard]] double jerk_bound(const LimitedQuantity& quantity, const Stretch& part, const HullBounds& hull) const;
  [[nodiscard]] double torque_bound(const LimitedQuantity& quantity, double r, const HullBounds& hull) const;

  const AnyCurve& curve_;
  std::size_t segment_;
  const SegmentHull& hull_;
  HullBounds rounding_;
  std::span<const LimitedQuantity> quantities_;
  Eigen::Matrix3d inertia_;
  double weight_;
  Motion m_{};
};

/// The position on one segment, likewise.
class Moving {
 public:
  Moving(const AnyPath& path, std::size_t segment, const PathHull& hull, const MotionQuantities& quantities)
      : path_(path), segment_(segment), hull_(hull), quantities_(quantities.all) {}

  void go_to(double t) { m_ = path_.linear_motion_on(segment_, t); }
  [[nodiscard]] double size(std::size_t k) const;
  [[nodiscard]] QuantitySizes bounds(const Stretch& part) const;
  /// The bounds hold what there is of it.
  void round(SegmentPeaks&, double) const {}

 private:
  const AnyPath& path_;
  std::size_t segment_;
  const PathHull& hull_;
  std::span<const LimitedQuantity> quantities_;
  LinearMotion m_{};
};

}}  // namespace orispline
