// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/reduce/tolerance_check.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A sample that a geodesic misses by more than the tolerance.
struct Violation {
  std::size_t sample;
  double beyond;  ///< of the angle above its tolerance [rad]; 0 where only the position is too far
};

/// Whether the geodesic between two samples, at constant rates, holds all samples between them.
///
/// Coarse to fine: blocks of 2^l intervals have a geodesic fitted to their samples and know which are farthest from it
/// (δ). Two geodesics that are e₀ and e₁ apart at the ends of a block are nowhere in it farther apart than
/// max(e₀, e₁) (θ/2)/sin(θ/2), θ = ψ + e₀ + e₁ < π, ψ the angle of the block's geodesic; so only samples with a greater
/// δ than the tolerance leaves need a look. Source: our own derivation, docs/reduce.md.
class SpanTest {
 public:
  explicit SpanTest(const ToleranceCheck& recording);

  /// One of the violations, of the samples between i and j; `turn` is the geodesic's rotation vector [rad], body frame
  /// of sample i. Nothing where all samples are held.
  [[nodiscard]] std::optional<Violation> violation(std::size_t i, std::size_t j, const Eigen::Vector3d& turn);
  /// Up to so many samples of the block, those farthest from the geodesic fitted to it; where none is, evenly spaced
  /// ones.
  [[nodiscard]] std::vector<std::size_t> farthest_from_block(std::size_t first, std::size_t intervals,
                                                             std::size_t count) const;

 private:
  struct Pose {
    Eigen::Quaterniond orientation;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  };
  /// A geodesic near the samples of a block.
  struct Block {
    Pose first, last;    ///< its ends
    double angle = 0.0;  ///< that it turns by [rad]
    bool known = false;  ///< whether all samples are within the tolerance of it
  };
  /// How far a sample is from its block's geodesic, by the tolerance.
  struct Miss {
    double miss;
    std::size_t sample;
  };
  struct Level {
    std::size_t intervals;  ///< of a block
    std::vector<Block> blocks;
    std::vector<Miss> largest;  ///< of every block as many as kept(), the largest first
    /// Most of all but a quarter of the samples are never asked for.
    [[nodiscard]] std::size_t kept() const { return intervals < 4 ? intervals - 1 : intervals / 4; }
  };
  /// Between two samples at which the geodesic is known.
  struct Piece {
    std::size_t first, last;
    Pose at_first, at_last;
  };
  class Geodesic;

  void add_level(std::size_t intervals);
  [[nodiscard]] Block fitted(std::size_t first, std::size_t last) const;
  /// Of all samples between the block's ends, the largest first.
  [[nodiscard]] std::vector<Miss> misses(const Block& block, std::size_t first, std::size_t last) const;
  [[nodiscard]] const Level* level_of(const Piece& piece) const;
  /// How far a geodesic is from the block's between the ends of the piece at most, by the tolerance.
  [[nodiscard]] double distance(const Block& block, const Piece& piece) const;
  /// Samples of the block that have to be looked at; nothing where they are not known.
  [[nodiscard]] std::optional<std::span<const Miss>> doubtful(const Piece& piece) const;

  const ToleranceCheck& recording_;
  double largest_angle_;       ///< at which a sample is held without a look [rad]
  std::vector<Level> levels_;  ///< of blocks of 2, 4, 8 … intervals
  std::vector<Piece> pieces_;  ///< still to be looked into, coarse ones first
  std::size_t failed_ = 0;     ///< the last violation found
};

}}  // namespace orispline
