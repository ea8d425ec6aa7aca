// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/optimise/recording.hpp>

namespace orispline::optimise {

/// A sample that a geodesic misses by more than the tolerance.
struct Violation {
  std::size_t sample;
  double beyond;  ///< of the angle above its tolerance [rad]; 0 where only the position is too far
};

/// Whether the geodesic between two samples, at constant rates, holds all samples between them.
///
/// Coarse to fine: blocks of 2^l intervals know how far their samples are from the block's own geodesic (δ). Two
/// geodesics that are e₀ and e₁ apart at the ends of a block are nowhere in it farther apart than
/// max(e₀, e₁) (θ/2)/sin(θ/2), θ = ψ + e₀ + e₁ < π, ψ the angle between the block's ends; so one look at a block's ends
/// mostly accepts all of its samples. Source: our own derivation, docs/reduce.md.
class SpanTest {
 public:
  explicit SpanTest(const Recording& recording);

  /// One of the violations, of the samples between i and j; `turn` is the geodesic's rotation vector [rad], body frame
  /// of sample i. Nothing where all samples are held.
  [[nodiscard]] std::optional<Violation> violation(std::size_t i, std::size_t j, const Eigen::Vector3d& turn);

 private:
  /// The geodesic from a block's first sample to its last.
  struct Chord {
    double angle;          ///< that it turns by [rad]
    double miss;           ///< largest angle between it and a sample [rad]
    double position_miss;  ///< likewise [m]
  };
  /// How far a geodesic is from a sample, or a little less far.
  struct Distance {
    double angle = 0.0, position = 0.0;  ///< [rad], [m]
  };
  /// Between two samples at which the geodesic is known.
  struct Piece {
    std::size_t first, last;
    Distance at_first, at_last;
  };
  class Geodesic;

  void add_level(std::size_t intervals);
  [[nodiscard]] Chord chord_of(std::size_t first, std::size_t last) const;
  [[nodiscard]] bool holds(const Piece& piece) const;

  const Recording& recording_;
  double largest_angle_;                    ///< at which a block is accepted [rad]
  std::vector<std::vector<Chord>> chords_;  ///< of the blocks of 2, 4, 8 … intervals
  std::vector<Piece> pieces_;               ///< still to be looked into, coarse ones first
  std::size_t failed_ = 0;                  ///< the last violation found
};

}  // namespace orispline::optimise
