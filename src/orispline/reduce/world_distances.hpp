// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/taken_clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far clips with fewer keys are from the one that they were made of, in the world. Where its joints are is found
/// once, as far as there is room for it.
class WorldDistances {
 public:
  /// Refers to the skeleton and the clip, which was looked at. `again`: whether several clips will be asked for.
  WorldDistances(const Skeleton& skeleton, const TakenClip& taken, double shell, bool again);

  /// The largest shell distance of any joint, at the clip's times and between them, as differences() finds it. The
  /// channels are those of the clip, in their order. Precondition: the clip has times.
  [[nodiscard]] ClipReduction::Worst farthest(const Clip& after);

 private:
  /// What tells a joint's pose in the frame of its parent at the clip's times, where it is known.
  struct KnownPose {
    bool is_known = true;  ///< what is absent rests
    const Eigen::Quaterniond* rotations = nullptr;
    const Eigen::Vector3d* translations = nullptr;
  };

  [[nodiscard]] std::vector<KnownPose> known_poses() const;
  /// Of all joints at the k-th time, as the clip was taken.
  void place(std::size_t k, std::span<Eigen::Affine3d> world) const;
  [[nodiscard]] std::span<const Eigen::Affine3d> remembered(std::size_t k);
  /// Of each joint, whether it may be elsewhere in the world.
  [[nodiscard]] std::vector<bool> may_be_apart(const Clip& after) const;

  const Skeleton& skeleton_;
  const TakenClip& taken_;
  double shell_;
  ClipMotion motion_;
  std::vector<KnownPose> known_;
  std::vector<Eigen::Affine3d> remembered_, scratch_;
  std::size_t times_remembered_ = 0, most_remembered_;
};

}}  // namespace orispline
