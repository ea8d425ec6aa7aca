// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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

 private:
  explicit Skeleton(std::vector<Joint> joints) : joints_(std::move(joints)) {}

  std::vector<Joint> joints_;
};

}}  // namespace orispline
