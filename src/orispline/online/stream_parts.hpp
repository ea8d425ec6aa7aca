// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <tuple>

#include <orispline/curve/key_parts.hpp>
#include <orispline/online/stream_method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A part of keys as one key of a stream brings it.
template <class T>
struct StreamPart {
  KeyPart<T> of_keys;
  std::optional<T> StreamKey::*value;
  bool KeyParts::*is_there;
  const char* article;  ///< of its name
};

/// One for each of `key_parts`, in their order.
inline constexpr std::tuple stream_parts{
    StreamPart<Eigen::Vector3d>{std::get<0>(key_parts), &StreamKey::position, &KeyParts::position, "a"},
    StreamPart<Eigen::Vector3d>{std::get<1>(key_parts), &StreamKey::angular_velocity, &KeyParts::angular_velocity,
                                "an"},
    StreamPart<Eigen::Vector3d>{std::get<2>(key_parts), &StreamKey::angular_acceleration,
                                &KeyParts::angular_acceleration, "an"},
    StreamPart<Eigen::Vector3d>{std::get<3>(key_parts), &StreamKey::angular_jerk, &KeyParts::angular_jerk, "an"},
    StreamPart<Eigen::Quaterniond>{std::get<4>(key_parts), &StreamKey::inner_leaving, &KeyParts::inner_leaving, "a"},
    StreamPart<Eigen::Quaterniond>{std::get<5>(key_parts), &StreamKey::inner_arriving, &KeyParts::inner_arriving,
                                   "an"}};
static_assert(std::tuple_size_v<decltype(stream_parts)> == std::tuple_size_v<decltype(key_parts)>);

template <class Visit>
constexpr void for_each_stream_part(Visit visit) {
  std::apply([&visit](const auto&... part) { (visit(part), ...); }, stream_parts);
}

}}  // namespace orispline
