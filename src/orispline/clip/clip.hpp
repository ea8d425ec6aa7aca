// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/clip/shared_list.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/math/geodesic.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How a channel goes from one key to the next. The words are glTF's.
enum class ChannelInterpolation {
  step,         ///< it keeps the value of the key before
  linear,       ///< slerp the shorter way, or a straight line
  cubicspline,  ///< a cubic Hermite polynomial of the components; of rotations normalised
};

/// One property of a joint over time: its rotation, translation or scale. Vectors have one entry per key.
template <CurvePoint P>
struct Channel {
  std::size_t joint = 0;  ///< index in the skeleton
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  SharedList<double> times{};  ///< [s], finite, strictly increasing; one at least
  SharedList<P> values{};      ///< unit quaternions from joint to parent, or vectors in the frame of the parent
  /// Time derivatives of the values before and after each key, component by component [1/s]; empty unless the
  /// interpolation is `cubicspline`.
  SharedList<P> in_tangents{}, out_tangents{};

  [[nodiscard]] std::size_t size() const noexcept { return times.size(); }
};
/// Where the keys of a channel are in memory, and how it goes between them: the same for channels that share all that.
template <CurvePoint P>
using PlacesOfKeys = std::tuple<ChannelInterpolation, const double*, const P*, const P*, const P*>;
template <CurvePoint P>
[[nodiscard]] PlacesOfKeys<P> places_of_keys(const Channel<P>& channel) noexcept {
  return {channel.interpolation, channel.times.data(), channel.values.data(), channel.in_tangents.data(),
          channel.out_tangents.data()};
}

using RotationChannel = Channel<Eigen::Quaterniond>;
using VectorChannel = Channel<Eigen::Vector3d>;

/// Weights of the morph targets that a joint has, three to a channel: the components of channel k are the weights 3k to
/// 3k + 2, and 0 behind the last. The keys of the channels may differ.
struct WeightChannels {
  std::size_t joint = 0;  ///< index in the skeleton; of all channels too
  std::size_t count = 0;  ///< of weights
  std::vector<VectorChannel> triples{};
};

/// The channel of that joint; null where there is none.
template <CurvePoint P>
[[nodiscard]] const Channel<P>* channel_of(const std::vector<Channel<P>>& channels, std::size_t joint) noexcept {
  const auto found = std::ranges::find(channels, joint, &Channel<P>::joint);
  return found == channels.end() ? nullptr : &*found;
}

// GCC 12 fails where it meets a list of members by their names before any other use of their defaults.
static_assert(std::is_default_constructible_v<RotationChannel> && std::is_default_constructible_v<VectorChannel>);

/// Where a joint is in the frame of its parent: a point p of the joint is at translation + rotation (scale ∘ p) there.
struct JointPose {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         ///< in the file's unit of length
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< joint to parent, a unit quaternion
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();               ///< along the joint's axes; may be negative
};

/// The parent of a joint that has none.
inline constexpr std::size_t no_parent = std::numeric_limits<std::size_t>::max();

/// A joint, or what else is placed by a parent.
struct Joint {
  std::string name{};
  std::size_t parent = no_parent;  ///< index in the skeleton
  JointPose rest{};                ///< where no channel says otherwise
};

/// Joints in an order in which parents come first.
class ORISPLINE_EXPORT Skeleton {
 public:
  Skeleton() = default;

  /// Errors (bad_data): a parent that does not come before its joint; a rest pose with a number that is not finite or a
  /// rotation that is no unit quaternion. They name the joint.
  [[nodiscard]] static Expected<Skeleton> make(std::vector<Joint> joints);

  [[nodiscard]] std::size_t size() const noexcept { return joints_.size(); }
  [[nodiscard]] std::span<const Joint> joints() const noexcept { return joints_; }
  [[nodiscard]] const Joint& operator[](std::size_t joint) const noexcept { return joints_[joint]; }
  /// The first joint of that name; nothing where there is none.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept;
  /// What people are told a joint by: its name, or where others have that too the names from the root down to it, such
  /// as `Armature/Bone`; of many the last few.
  [[nodiscard]] std::string shown_name(std::size_t joint) const;

 private:
  explicit Skeleton(std::vector<Joint> joints);

  std::vector<Joint> joints_;
  std::vector<bool> shares_name_;  ///< of each joint
};

/// One animation of a skeleton. Of a joint there is at most one channel in each list.
struct ORISPLINE_EXPORT Clip {
  std::string name{};
  std::vector<RotationChannel> rotations{};
  std::vector<VectorChannel> translations{}, scales{};
  std::vector<WeightChannels> weights{};  ///< none of a joint: they stay as the file has them

  /// From the first key to the last of what else the file moves in it, which is passed on [s].
  std::optional<Domain> passed_on{};

  /// From its first key to its last [s]; 0 to 0 where it has no channel.
  [[nodiscard]] Domain domain() const noexcept;
  /// The same with what is passed on.
  [[nodiscard]] Domain whole_domain() const noexcept;
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
