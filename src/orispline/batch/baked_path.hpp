// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/batch/baked_curve.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A path turned into polynomials, to be stored and played. `bake_path` makes one.
class ORISPLINE_EXPORT BakedPath {
 public:
  static constexpr int degree = 5;

  /// x, y and z are each first + others[0] s + … with s = (t - middle) * per_step in [-1, 1]. Where a piece is stands
  /// in double precision: a path far from 0, or over a long way, keeps its digits.
  struct Piece {
    double first[3];          ///< [m]
    float others[3][degree];  ///< [m]
    double middle, per_step;  ///< [s], [1/s]
  };

  /// The ends of the pieces [s].
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  /// Of a single key there is one.
  [[nodiscard]] std::span<const Piece> pieces() const noexcept { return pieces_; }
  /// The largest distance from the path that was found while baking [m].
  [[nodiscard]] double largest_difference() const noexcept { return largest_difference_; }

  /// Position at time t [s]; outside the knots the one at the end, NaN for NaN.
  [[nodiscard]] Eigen::Vector3d operator()(double t) const noexcept;

 private:
  friend Expected<BakedPath> bake_path(const AnyPath& path, double tolerance, const BakeOptions& options,
                                       const Progress& progress);
  BakedPath(Knots knots, std::vector<Piece> pieces, double largest_difference)
      : knots_(std::move(knots)), pieces_(std::move(pieces)), largest_difference_(largest_difference) {}

  Knots knots_;
  std::vector<Piece> pieces_;
  double largest_difference_;
};

/// Bakes a path so that no position is farther from the path's own than `tolerance` [m], which is checked as bake()
/// does, with the same reserve of a factor of 2.
///
/// Errors: bad_argument for a tolerance that is not positive and finite, and for a segment, named as the key, on which
/// it cannot be reached, or on which more pieces would be needed than the options allow; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<BakedPath> bake_path(const AnyPath& path, double tolerance,
                                                             const BakeOptions& options = {},
                                                             const Progress& progress = {});

}}  // namespace orispline
