// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The axes of three turns in their order, and which axes they are.
struct EulerOrder {
  enum class Axes {
    of_body,   ///< intrinsic: every turn moves the axes of the next ones
    of_world,  ///< extrinsic: the axes stand still
  };

  std::array<int, 3> turns{2, 1, 0};  ///< 0 x, 1 y, 2 z; no axis twice in succession
  Axes axes = Axes::of_body;

  /// Whether the third turn is about the axis of the first (proper Euler angles), else all three differ (Tait–Bryan).
  [[nodiscard]] bool is_proper() const noexcept { return turns[0] == turns[2]; }
  [[nodiscard]] bool operator==(const EulerOrder&) const noexcept = default;
};

/// Sine of half the angle to a gimbal lock up to which the first and the third angle are rounding; only their sum or
/// their difference means anything there.
inline constexpr double gimbal_lock_tolerance = 16.0 * std::numeric_limits<double>::epsilon();

/// `ZYX`: about the axes of the body, in this order; `zyx`: about those of the world. Nothing for any other text than
/// three letters of one case, of which no two neighbours are the same.
[[nodiscard]] inline std::optional<EulerOrder> euler_order_of(std::string_view name) noexcept {
  if (name.size() != 3 || name[0] == name[1] || name[1] == name[2]) return std::nullopt;
  for (const auto& [letters, axes] :
       {std::pair("XYZ", EulerOrder::Axes::of_body), std::pair("xyz", EulerOrder::Axes::of_world)}) {
    const std::array places{std::string_view(letters).find(name[0]), std::string_view(letters).find(name[1]),
                            std::string_view(letters).find(name[2])};
    if (places[0] < 3 && places[1] < 3 && places[2] < 3)
      return EulerOrder{{static_cast<int>(places[0]), static_cast<int>(places[1]), static_cast<int>(places[2])}, axes};
  }
  return std::nullopt;
}

/// Orientation after three turns by the angles [rad], in the order of the turns.
[[nodiscard]] inline Eigen::Quaterniond quaternion_from_euler(const EulerOrder& order,
                                                              const Eigen::Vector3d& angles) noexcept {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Quaterniond turn =
        exp<double>(angles[i] * Eigen::Vector3d::Unit(order.turns[static_cast<std::size_t>(i)]));
    q = order.axes == EulerOrder::Axes::of_body ? q * turn : turn * q;
  }
  return q;
}

/// Angles [rad] of the three turns that make an orientation; q and -q have the same ones.
///
/// First and third are in [-π, π], the second is in [-π/2, π/2] for three different axes, in [0, π] for a proper order.
/// Where it is at the end of its range (gimbal lock, within `gimbal_lock_tolerance`) the third angle is 0. Anywhere
/// else the angles give back the orientation to rounding, however near the lock.
///
/// For the proper order i, j, i with e_i × e_j = ε e_k the half angles α, β, γ have
/// w = cos β cos(α+γ), q_i = cos β sin(α+γ), q_j = sin β cos(α-γ), q_k = ε sin β sin(α-γ).
/// Three different axes i, j, k are reduced to that: e_k is -ε e_i after a quarter turn about e_j, so q times that
/// quarter turn is the proper product of α, β + π/4 and -ε γ. Turns about the axes of the world are those about the
/// axes of the body in reverse order.
[[nodiscard]] inline Eigen::Vector3d euler_angles(const EulerOrder& order, const Eigen::Quaterniond& q) noexcept {
  constexpr double pi = std::numbers::pi;
  const bool of_world = order.axes == EulerOrder::Axes::of_world;
  const int i = order.turns[of_world ? 2 : 0], j = order.turns[1], k = 3 - i - j;
  const double handedness = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;

  Eigen::Vector4d p(q.w(), q.vec()[i], q.vec()[j], handedness * q.vec()[k]);
  if (!order.is_proper()) p = Eigen::Vector4d(p[0] - p[2], p[1] - p[3], p[2] + p[0], p[3] + p[1]) / std::numbers::sqrt2;
  double cosine = p.head<2>().norm(), sine = p.tail<2>().norm();
  double sum = atan2_of(p[1], p[0]), difference = atan2_of(p[3], p[2]);
  const double lock = of_world ? -1.0 : 1.0;  // makes the third turn, as the caller counts, the one that is 0
  if (sine <= gimbal_lock_tolerance) sine = 0.0, difference = lock * sum;
  if (cosine <= gimbal_lock_tolerance) cosine = 0.0, sum = lock * difference;

  Eigen::Vector3d angles(sum + difference, 2.0 * atan2_of(sine, cosine), sum - difference);
  if (!order.is_proper()) angles = {angles[0], angles[1] - pi / 2, -handedness * angles[2]};
  for (const int outer : {0, 2}) angles[outer] = std::remainder(angles[outer], 2.0 * pi);
  return of_world ? Eigen::Vector3d(angles.reverse()) : angles;
}

}}  // namespace orispline
