// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a key may have besides its time and orientation.
template <class T>
struct KeyPart {
  std::vector<T> KeyframeData::*list;
  const char *one, *many;                                                            ///< its name
  std::optional<Error> (*check)(std::size_t key, const char* what, const T& value);  ///< what it must be
};

/// THE list.
inline constexpr std::tuple key_parts{
    KeyPart<Eigen::Vector3d>{&KeyframeData::positions, "position", "positions", check_vector},
    KeyPart<Eigen::Vector3d>{&KeyframeData::angular_velocities, "angular velocity", "angular velocities", check_rate},
    KeyPart<Eigen::Vector3d>{&KeyframeData::angular_accelerations, "angular acceleration", "angular accelerations",
                             check_rate},
    KeyPart<Eigen::Vector3d>{&KeyframeData::angular_jerks, "angular jerk", "angular jerks", check_rate},
    KeyPart<Eigen::Quaterniond>{&KeyframeData::inner_leaving, "leaving inner quaternion", "leaving inner quaternions",
                                check_inner},
    KeyPart<Eigen::Quaterniond>{&KeyframeData::inner_arriving, "arriving inner quaternion",
                                "arriving inner quaternions", check_inner}};

template <class Visit>
constexpr void for_each_part(Visit visit) {
  std::apply([&visit](const auto&... part) { (visit(part), ...); }, key_parts);
}

/// The first error that a check of a part finds.
template <class Check>
[[nodiscard]] std::optional<Error> first_error_of_parts(Check check) {
  std::optional<Error> error;
  for_each_part([&](const auto& part) {
    if (!error) error = check(part);
  });
  return error;
}

/// Calls `visit` with every list of the data that has an entry per key, empty ones included.
template <class Visit>
void for_each_list(KeyframeData& data, Visit visit) {
  visit(data.times);
  visit(data.orientations);
  for_each_part([&](const auto& part) { visit(data.*part.list); });
}

/// Data of which `made_of` makes every list from the one of these.
template <class MadeOf>
[[nodiscard]] KeyframeData list_by_list(const KeyframeData& data, MadeOf made_of) {
  KeyframeData made{.times = made_of(data.times), .orientations = made_of(data.orientations), .jumps = data.jumps};
  for_each_part([&](const auto& part) { made.*part.list = made_of(data.*part.list); });
  return made;
}

/// The entries of a list at these indices; nothing of an empty list.
template <class T>
[[nodiscard]] std::vector<T> entries_at(const std::vector<T>& list, const auto& indices) {
  std::vector<T> some;
  if (list.empty()) return some;
  some.reserve(indices.size());
  for (const auto i : indices) some.push_back(list[i]);
  return some;
}

}}  // namespace orispline
