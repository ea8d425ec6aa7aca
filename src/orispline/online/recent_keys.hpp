// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <orispline/curve/control_points.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The newest keys of a stream, at most the four that a segment depends on; their signs are chosen already.
struct RecentKeys {
  static constexpr std::size_t most = 4;
  std::size_t size = 0;
  std::array<double, most> times{};                     ///< [s]
  std::array<Eigen::Quaterniond, most> orientations{};  ///< body to world
  std::array<Eigen::Vector3d, most> positions{};        ///< [m]
  std::array<Eigen::Vector3d, most - 1> increments{};   ///< rotation vectors from each key to the next [rad]

  /// Adds a key; the oldest one goes when there are `most`.
  void push(double time, const Eigen::Quaterniond& orientation, const Eigen::Vector3d& position) noexcept;
};

enum class EndKey { first, last };

/// What leads from the ghost key to an end key seen inwards: rotation vector [rad] and displacement [m].
struct GhostIncrements {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero(), shift = Eigen::Vector3d::Zero();
};

/// The ghost beyond the first or the last of these keys by the rule of that end; `weights` seen inwards from the key.
/// Errors: those of `ghost_increment`. Success allocates nothing.
[[nodiscard]] Expected<GhostIncrements> ghost_beyond(EndKey which, const RecentKeys& keys, const End& end,
                                                     RateWeights weights);

}}  // namespace orispline
