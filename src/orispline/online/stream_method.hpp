// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One key of a stream, body to world.
struct StreamKey {
  double time = 0.0;  ///< [s]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::optional<Eigen::Vector3d> position{};                            ///< [m], world frame
  std::optional<Eigen::Vector3d> angular_velocity{};                    ///< [rad/s], body frame
  std::optional<Eigen::Vector3d> angular_acceleration{};                ///< [rad/s²], body frame
  std::optional<Eigen::Vector3d> angular_jerk{};                        ///< [rad/s³], body frame
  std::optional<Eigen::Quaterniond> inner_leaving{}, inner_arriving{};  ///< those of KeyframeData
  /// By name, the parameters whose values come with the keys: those without values in the options of the curve.
  std::map<std::string, double, std::less<>> settings{};
};

/// The orientation of a key that has passed its check, normalised as Keyframes::make does.
[[nodiscard]] ORISPLINE_EXPORT Eigen::Quaterniond unit_orientation(const Eigen::Quaterniond& orientation);

/// What the keys of a stream have besides time and orientation: all of them or none.
struct KeyParts {
  bool position = false, angular_velocity = false, angular_acceleration = false, angular_jerk = false,
       inner_leaving = false, inner_arriving = false;
  bool operator==(const KeyParts&) const = default;
};

[[nodiscard]] ORISPLINE_EXPORT KeyParts parts_of(const StreamKey& key) noexcept;

/// The orientation of the key after those at `before` [s], key `index` of the stream, normalised. Errors: what
/// Keyframes::make refuses, in the same words, and other parts than `wanted`. Success allocates nothing.
[[nodiscard]] ORISPLINE_EXPORT Expected<Eigen::Quaterniond> checked_orientation(std::uint64_t index,
                                                                                const StreamKey& key,
                                                                                std::span<const double> before,
                                                                                const KeyParts& wanted);

/// A family with the options of a curve whose keys arrive one by one, and which keys a part of that curve needs to have
/// the bits of the whole.
struct ORISPLINE_EXPORT StreamMethod {
  const FamilyInfo* family;
  CurveOptions options;              ///< every parameter has one value for all keys …
  std::vector<std::string> per_key;  ///< … but for these, in the order of their names, whose values come with the keys
  std::optional<std::size_t> keys_beside;  ///< on either side of a segment; absent: a segment depends on all keys
  std::size_t first_key;                   ///< where the curve begins; it ends as many before the last
  std::size_t keys_at_start;               ///< that must have come before any segment is final
  std::size_t keys_at_end;                 ///< the last ones, on which the end depends
  std::shared_ptr<const OwnFamily> own;    ///< keeps the family, where it is not in the registry

  /// As for make_curve(); a parameter without values has them with the keys.
  ///
  /// Errors (bad_argument): an unknown method, a loop, parameters per key, options that the family does not accept or
  /// with which no end can have the given rate.
  [[nodiscard]] static Expected<StreamMethod> make(const Method& method);

  /// That so many keys make a curve: bad_data for fewer than the end rules need or another count than the method takes.
  /// Success allocates nothing.
  [[nodiscard]] std::optional<Error> check_count(std::size_t keys) const;
  /// That the key brings values of the parameters `per_key` and of no others, each in its range.
  [[nodiscard]] std::optional<Error> check_settings(std::uint64_t index, const StreamKey& key) const;
};

}}  // namespace orispline
