// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/cuts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A clip that gets fewer keys, and the motion that it is taken to be.
struct TakenClip {
  Clip clip{};                                                      ///< with short cuts
  bool is_smooth = false;                                           ///< between its keys
  std::size_t cuts = 0;                                             ///< in the clip
  std::vector<std::vector<Cut>> of_rotations{}, of_translations{};  ///< of every channel
  std::vector<ChannelCurve<Eigen::Quaterniond>> rotations{};        ///< of the channels, in their order
  std::vector<ChannelCurve<Eigen::Vector3d>> translations{}, scales{};
  std::vector<double> times{};  ///< of its keys, and those between at which it is looked at
  /// The motions of the channels at with_looks_between() of their own times; none of channels for which there is no
  /// room, or that have one key.
  std::vector<std::vector<Eigen::Quaterniond>> rotation_looks{};
  std::vector<std::vector<Eigen::Vector3d>> translation_looks{};

  TakenClip(const Skeleton& skeleton, const Clip& before, const ClipReduceOptions& options);

  /// Finds the looks, on up to that many threads.
  void look(unsigned threads);

  /// What the clip with fewer keys is measured against: channels that are the same are no distance off. Refers to the
  /// skeleton.
  [[nodiscard]] ClipMotion beside(const Skeleton& skeleton, const Clip& after) const;
  /// Whether that is the motion that was taken, for no channel with another one is the same.
  [[nodiscard]] bool is_beside_as_taken(const Clip& after) const;
};

}}  // namespace orispline
