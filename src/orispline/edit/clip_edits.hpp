// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/edit/join.hpp>
#include <orispline/edit/loop.hpp>
#include <orispline/edit/travel.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/fields/words.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which axis of the world points up.
enum class UpAxis { y, z };
template <>
inline constexpr std::array words<UpAxis>{word("y", UpAxis::y, "As in glTF and most BVH files"),
                                          word("z", UpAxis::z, "As in robotics")};

/// What is done to a clip, in this order.
struct ClipEdits {
  std::optional<double> from{}, to{};  ///< the part that is kept [s]; absent: from its start, to its end
  bool reverse = false;
  double speed = 1.0;
  std::optional<double> blend{};  ///< how long a clip goes over into the one that is appended [s]; absent: 0.2
  bool loop = false;
  std::optional<double> period_from{}, period_to{};  ///< of the loop that is looked for [s]; absent: the whole clip
  UpAxis up = UpAxis::y;
  std::optional<double> rate{};   ///< of even keys, with one at the end [Hz]; absent: the keys stay
  std::optional<double> shift{};  ///< the time of its start [s]; absent: it stays where it is
};

/// Joints that edits are about; `no_parent`: none.
struct EditedJoints {
  std::size_t root = no_parent;       ///< whose way a loop keeps, and goes on in an appended clip
  std::size_t extracted = no_parent;  ///< whose way goes into a node above it
  std::size_t node = no_parent;       ///< that one; `no_parent`: the topmost one above it
  std::size_t in_place = no_parent;   ///< whose way is taken out
};

/// A clip that is appended, of a skeleton of its own.
struct AppendedClip {
  const Skeleton& skeleton;
  const Clip& clip;
};

/// A clip with its edits, and what was done to it.
struct ClipEdit {
  Clip clip{};
  Domain before{0.0, 0.0}, part{0.0, 0.0};  ///< of the clip as it was, and which of it was kept [s]
  std::optional<Domain> blend{};            ///< when it goes over into the appended one [s]; absent where there is none
  double appended_turn = 0.0;               ///< of that one about up [rad]
  std::optional<ClipLoop> loop{};           ///< without its clip; absent where none was asked for
  std::optional<Travel> taken{};            ///< out of a joint; absent where that was not asked for
};

/// Error (bad_argument): options that contradict each other, whatever the clip is.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const ClipEdits& edits);

/// Errors, which name the clip: bad_argument for a part outside of it; bad_data for a cut where a cubic passes through
/// 0 and is no rotation; those of check(), with_joints_of(), joined(), best_period(), looped() and with_root_motion().
[[nodiscard]] ORISPLINE_EXPORT Expected<ClipEdit> edited(const Skeleton& skeleton, const Clip& clip,
                                                         const ClipEdits& edits, const EditedJoints& joints = {},
                                                         const AppendedClip* appended = nullptr);

}}  // namespace orispline
