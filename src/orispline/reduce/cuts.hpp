// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A jump of a joint that is no motion: from a key to the next one [s].
struct Cut {
  double before = 0.0, after = 0.0;
};

/// Which jumps part a clip.
enum class CutSearch {
  close_keys,    ///< those between two keys that are at most 2 ms apart, and far nearer than their neighbours
  single_steps,  ///< those too of one step that neither side of it foretells
};

/// The cuts of every joint of the skeleton, in the order of time. A cut of one of its channels is one of the joint.
///
/// A jump is more than five times as large as the rates of the two steps on either side of it would make it. A single
/// step is that large beside these steps themselves, 10° at least, or a twentieth of the longest chain of bones; of a
/// skeleton without bones, of the box that the joint moves in. What a `cubicspline` or a channel of steps does is said
/// by it: only between close keys has it cuts.
[[nodiscard]] std::vector<std::vector<Cut>> cuts_of(const Skeleton& skeleton, const Clip& clip, CutSearch search);

/// How many cuts there are, those of several joints at one time as one.
[[nodiscard]] std::size_t count_of(const std::vector<std::vector<Cut>>& of_joints);

/// The clip with the value before a cut held until 1 ms before its end, where it lasts longer: so a file can say that
/// it is none of the motion. The cuts are then so short.
[[nodiscard]] Clip with_short_cuts(Clip clip, std::vector<std::vector<Cut>>& of_joints);

/// Those of a channel: from a key of it to the next, where it has keys at both ends of the joint's cut.
template <CurvePoint P>
[[nodiscard]] std::vector<Cut> cuts_in(const Channel<P>& channel, const std::vector<Cut>& of_joint);

extern template std::vector<Cut> cuts_in(const RotationChannel&, const std::vector<Cut>&);
extern template std::vector<Cut> cuts_in(const VectorChannel&, const std::vector<Cut>&);

}}  // namespace orispline
