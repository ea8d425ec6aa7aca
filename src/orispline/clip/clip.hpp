// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/clip/channel.hpp>
#include <orispline/clip/skeleton.hpp>
#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One animation of a skeleton. Of a joint there is at most one channel in each list.
struct ORISPLINE_EXPORT Clip {
  std::string name{};
  std::vector<RotationChannel> rotations{};
  std::vector<VectorChannel> translations{}, scales{};

  /// From its first key to its last [s]; 0 to 0 where it has no channel.
  [[nodiscard]] Domain domain() const noexcept;
};

/// Whether the clip is sound and belongs to the skeleton.
///
/// Errors (bad_data), which name the clip, the joint and the key: a channel without keys, of a joint that is not there
/// or has one already, with vectors of different length, with a time that is not finite or does not increase, with a
/// value that is not finite, with a rotation that is no unit quaternion.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_clip(const Skeleton& skeleton, const Clip& clip);

/// `clip 'Walking_A', joint 'hand.r'`: what messages name a channel by.
[[nodiscard]] ORISPLINE_EXPORT std::string place_of(const Skeleton& skeleton, const Clip& clip, std::size_t joint);

}}  // namespace orispline
