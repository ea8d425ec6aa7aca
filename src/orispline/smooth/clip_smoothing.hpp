// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/smooth/contacts.hpp>
#include <orispline/smooth/smooth.hpp>
#include <orispline/smooth/wrong_runs.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A clip whose joints were smoothed, and what was found.
struct ClipSmoothing {
  /// Of one joint.
  struct OfJoint {
    std::size_t joint;
    Smoothing smoothing;
    double largest_change = 0.0;  ///< between the rotation before and after, over its keys [rad]
    double change_at = 0.0;       ///< [s]
  };

  Clip clip{};
  std::vector<OfJoint> joints{};    ///< that were smoothed
  std::vector<WrongRun> runs{};     ///< frames that were bridged before that
  std::vector<Contact> contacts{};  ///< that were held after it
  std::size_t left = 0;             ///< rotations that were not: they rest, are steps or splines, or have too few keys
  std::vector<Error> refused{};     ///< why others were not, one for each, with clip and joint
};

/// Fewer keys of a channel are left as they are: they do not tell noise from motion.
inline constexpr std::size_t fewest_smoothed_keys = 20;

/// Every one of the clips with its `linear` rotations smoothed, joint by joint, as smooth() does it; with a translation
/// that has the same key times and moves, that too. Before that, unless `runs` says otherwise, the wrong_runs() of a
/// clip are bridged by what the other keys of the joint lead to. All else stays as it is, and so does a rotation that
/// smooth() refuses for its samples. Six joints and more with the same even key times, sixty at least, are then
/// smoothed together, by smooth_together(), unless `smoothing_time`, `penalty`, `gap` or `loss` says how each is to be
/// smoothed. Of fewer those with `noise_time` share σ, unless `noise` states it. A rotation that is too short for that
/// time has none.
///
/// On up to that many threads, 0 means one per core; the results are the same on any number of them.
/// `keep_contacts` are held at last. Errors: those of smooth() but for bad_data, with clip and joint; those of
/// held_contacts(); bad_argument for `gyro`, since clips have no rates,
/// and for `sigma`, for which they have no room.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<ClipSmoothing>> smooth_clips(const Skeleton& skeleton,
                                                                                 std::span<const Clip> clips,
                                                                                 const SmoothOptions& options = {},
                                                                                 unsigned threads = 0);

}}  // namespace orispline
