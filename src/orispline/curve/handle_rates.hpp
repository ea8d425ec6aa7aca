// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The rates with which a curve leaves every key and arrives at it [1/s]: three times its Bézier handles per step.
struct HandleRates {
  std::vector<Eigen::Vector3d> leaving, arriving;
};

/// How far a handle turns away from its key: the rates there are those of the handle up to a full turn.
struct HandleTurn {
  std::size_t key = 0;
  double turn = 0.0;  ///< [rad]
};

[[nodiscard]] inline HandleTurn wider_of(const HandleTurn& a, const HandleTurn& b) { return b.turn > a.turn ? b : a; }

/// The handle that turns farthest, of all that the segments between keys have; `handles(i)` are the rotation vectors of
/// key i on leaving it and on arriving at it [rad].
template <class HandlesOf>
[[nodiscard]] HandleTurn widest_handle(std::size_t keys, HandlesOf handles) {
  HandleTurn widest;
  for (std::size_t i = 0; i < keys; ++i) {
    const auto [leaving, arriving] = handles(i);
    if (i + 1 < keys) widest = wider_of(widest, {i, leaving.norm()});
    if (i > 0) widest = wider_of(widest, {i, arriving.norm()});
  }
  return widest;
}

/// The Bézier handle that turns farthest from its key, from the rates of the handles.
[[nodiscard]] ORISPLINE_EXPORT HandleTurn widest_handle(std::span<const double> times, const HandleRates& rates);

}}  // namespace orispline
