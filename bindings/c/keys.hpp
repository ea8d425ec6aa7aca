// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/curve/track.hpp>

#include "handles.hpp"

namespace orispline::c {

/// Keys as C holds them: shared with the curves through them, for they never change.
struct Keys {
  std::shared_ptr<const Track> track;
  std::string read{};  ///< members of JSON that say what reading their file did; empty: they are from no file
};

template <>
struct HandleOf<orispline_keys> {
  using Body = Keys;
  static constexpr Kind kind = Kind::keys;
  static constexpr std::string_view name = "keys";
};

/// A column that keys have, and how many numbers a key has in it.
struct ColumnOfKeys {
  std::string_view name;
  std::size_t width;
};
/// All of them, the times first. They live as long as the track.
[[nodiscard]] std::vector<ColumnOfKeys> columns_of(const Track& track);

/// Error (bad_argument): an order that is none.
[[nodiscard]] Expected<void> check_order(orispline_order order);

/// The four numbers of a quaternion, which lie as Eigen has them, in an order.
template <class T, class Quaternion>
void put_quaternion(T* to, const Quaternion& q, orispline_order order) noexcept {
  const int first = order == ORISPLINE_WXYZ ? 1 : 0;
  to[order == ORISPLINE_WXYZ ? 0 : 3] = static_cast<T>(q.w());
  to[first] = static_cast<T>(q.x());
  to[first + 1] = static_cast<T>(q.y());
  to[first + 2] = static_cast<T>(q.z());
}

}  // namespace orispline::c
