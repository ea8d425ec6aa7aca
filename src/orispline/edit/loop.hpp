// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include <orispline/base/expected.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/edit/seam.hpp>
#include <orispline/fields/words.hpp>

// A clip that goes on from its end at its start.

namespace orispline { inline namespace ORISPLINE_ABI {

/// The joint whose travel a loop keeps, whichever of it and of the joints above it goes and turns.
struct LoopRoot {
  std::size_t joint = no_parent;                  ///< `no_parent`: all that moves comes back to where it was
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();  ///< of the world
};

/// How each value at the end of a loop is that at its start again: turned, and of positions moved across `up`.
struct LoopStep {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< about `up`, in the frame of the parent
  std::optional<Eigen::Vector3d> up{};  ///< of a position that travels, in that frame; absent: it comes back
};

/// How a loop was closed.
enum class LoopClosing {
  none,   ///< it went round already
  frame,  ///< it lacked keys that are the first ones again, and got them
  bent,   ///< the difference of the ends of some channels was spread over them
};

template <>
inline constexpr std::array words<LoopClosing>{word("none", LoopClosing::none), word("frame", LoopClosing::frame),
                                               word("bent", LoopClosing::bent)};

/// The largest change of a joint, between keys too.
struct LoopChange {
  LargestInTime largest{};  ///< [rad]; in the unit of lengths, in the world; or of factors
  std::size_t joint = no_parent;
};

/// Whether a clip may lack its closing key, as files do that are played over and over.
enum class ClosingKey { may_lack, is_there };

/// A clip that goes round, and what was done to it.
struct ClipLoop {
  Clip clip{};
  LoopClosing closing = LoopClosing::none;
  LoopChange rotation{}, translation{}, scale{};
  double travel = 0.0;             ///< of the root in one round, in the world, in the unit of lengths
  double turn = 0.0;               ///< of the root in one round, about up in the world [rad]; whole rounds count
  std::vector<JointTurn> turns{};  ///< of the root and the joints that carry it
};

/// The stretch of a clip that is most alike at its two ends, by the rotations of its joints and their rates; what a
/// root does across and about up does not count. Its ends are times of keys.
///
/// Errors (bad_argument of `period_from` and `period_to`): no two keys are so far apart.
[[nodiscard]] ORISPLINE_EXPORT Expected<Domain> best_period(const Skeleton& skeleton, const Clip& clip, Domain periods,
                                                            const LoopRoot& root = {});

/// The clip as a loop, from its first key to its last. Where the steps at the seam fit those beside it nothing is
/// bent, and a channel that ends one step before the others gets its first key there. Steps end on their first value.
/// Else each channel becomes q exp(c(t)), with c C2 in time, so that it has the same value, rate and acceleration
/// at both ends. Linear channels keep the times of their keys, and get more of them where a step takes more than a
/// sixteenth of the loop, or would turn by more than 179°; cubics may get more of them, to be within 1e-5 rad.
///
/// Errors (bad_data), which name the clip: fewer than three times of keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<ClipLoop> looped(const Skeleton& skeleton, const Clip& clip,
                                                         const LoopRoot& root = {},
                                                         ClosingKey key = ClosingKey::may_lack);

/// The curve of a channel that is bent into a loop over a domain. Errors: those of the curve through its keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<AnyCurve> bent_curve(const RotationChannel& channel, Domain domain,
                                                             const LoopStep& step = {});
[[nodiscard]] ORISPLINE_EXPORT Expected<AnyPath> bent_curve(const VectorChannel& channel, Domain domain,
                                                            const LoopStep& step = {});

}}  // namespace orispline
