// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include <orispline/analysis/segment_hull.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/retime/motion_limits.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The velocity of a path on one segment, a polynomial in Bernstein form.
class PathHull {
 public:
  /// Nothing for a path that is not of polynomials of degree 7 at most.
  [[nodiscard]] static std::optional<PathHull> of(const AnyPath& path, std::size_t segment);

  /// What a quantity of the position is nowhere above for u from `start` to `end` in [0, 1].
  [[nodiscard]] double bound(const LimitedQuantity& quantity, double start, double end) const;
  /// What there is of rounding in the bounds.
  [[nodiscard]] double rounding(const LimitedQuantity& quantity) const;

 private:
  HullVector velocity_{}, acceleration_{};
  double rounding_[2]{};  // of velocity and acceleration
};

}}  // namespace orispline
