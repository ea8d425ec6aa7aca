// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

#include <orispline/base/expected.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One key of a stream, body to world.
struct StreamKey {
  double time = 0.0;  ///< [s]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::optional<Eigen::Vector3d> position{};              ///< [m], world frame
  std::optional<Eigen::Vector3d> angular_velocity{};      ///< [rad/s], body frame
  std::optional<Eigen::Vector3d> angular_acceleration{};  ///< [rad/s²], body frame
  std::optional<Eigen::Vector3d> angular_jerk{};          ///< [rad/s³], body frame
  /// By name, the parameters whose values come with the keys: those without values in the options of the curve.
  std::map<std::string, double, std::less<>> settings{};
};

/// The orientation of a key that has passed its check, normalised as Keyframes::make does.
[[nodiscard]] ORISPLINE_EXPORT Eigen::Quaterniond unit_orientation(const Eigen::Quaterniond& orientation);

/// What the keys of a stream have besides time and orientation: all of them or none.
struct KeyParts {
  bool position = false, angular_velocity = false, angular_acceleration = false, angular_jerk = false;
  bool operator==(const KeyParts&) const = default;
};

[[nodiscard]] ORISPLINE_EXPORT KeyParts parts_of(const StreamKey& key) noexcept;

/// The orientation of the key after those at `before` [s], key `index` of the stream, normalised. Errors: what
/// Keyframes::make refuses, in the same words, and other parts than `wanted`. Success allocates nothing.
[[nodiscard]] ORISPLINE_EXPORT Expected<Eigen::Quaterniond> checked_orientation(std::uint64_t index,
                                                                                const StreamKey& key,
                                                                                std::span<const double> before,
                                                                                const KeyParts& wanted);

}}  // namespace orispline
