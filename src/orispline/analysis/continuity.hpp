// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <orispline/curve/curve.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far one rate of a curve jumps where its segments meet.
struct RateJump {
  double largest = 0.0;    ///< largest ‖right - left‖ at an interior key, in the unit of the rate
  std::size_t key = 0;     ///< where
  double magnitude = 0.0;  ///< largest ‖rate‖ on the curve, found at the keys and at three points of each segment
  double relative = 0.0;   ///< largest / magnitude; 0 where every jump is within the rounding of the rate itself
};

/// Where the orientation itself jumps, from one time to the next one that a double can tell from it, or at a key.
struct OrientationJump {
  double angle = 0.0;   ///< [rad]; 0: nowhere
  double time = 0.0;    ///< [s]
  std::size_t key = 0;  ///< the one before it, or that at which it is
};

/// The continuity in time that a curve really has on its keys.
struct ORISPLINE_EXPORT Continuity {
  RateJump angular_velocity{};      ///< [rad/s]
  RateJump angular_acceleration{};  ///< [rad/s²]
  RateJump angular_jerk{};          ///< [rad/s³]
  OrientationJump orientation{};    ///< the largest one, between keys or at one

  /// The largest k up to 3 for which no rate of order k or lower jumps by more than `continuity_tolerance`; -1 where
  /// the orientation itself jumps.
  [[nodiscard]] int order() const noexcept;
};

/// Relative jumps up to this one pass as continuous.
inline constexpr double continuity_tolerance = 1e-9;

/// Whether the end of a curve is joined to its beginning.
enum class Seam { open, closed };

/// One-sided rates compared at every interior key and, of a loop, where its end meets its beginning (key 0). A jump of
/// a rate of order k within 256 ε/h^k, h [s] being the smaller spacing beside the key, is rounding. Between the keys
/// the orientation is looked at: no rate tells that it jumps.
[[nodiscard]] ORISPLINE_EXPORT Continuity continuity_at_keys(const AnyCurve& curve, Seam seam = Seam::open);

/// The order at each knot, where segments meet, found in the same way: the largest k up to 3 for which no rate of order
/// k or lower jumps there, as the rates of the whole curve go; -1 where the orientation jumps there, or between it and
/// the next. Ends are joined to nothing, and have 3; those of a loop are one place. The least is the order of the
/// curve.
[[nodiscard]] ORISPLINE_EXPORT std::vector<int> orders_at_keys(const AnyCurve& curve, Seam seam = Seam::open);

/// Where a path goes at a moment, and how it bends by the angle travelled, whatever its speed.
struct PathShape {
  Eigen::Vector3d direction;       ///< e = ω/‖ω‖ [1], body frame
  Eigen::Vector3d curvature;       ///< κ = de/ds [1/rad]
  Eigen::Vector3d curvature_rate;  ///< dκ/ds [1/rad²]
};

/// With body rates ω, α, j and v = ‖ω‖, s [rad] the angle travelled:
///   e = ω/v,   κ = α⊥/v²,   dκ/ds = (j⊥ - ‖α⊥‖² e/v - 3 (α·e) α⊥/v)/v³   with x⊥ = x - (x·e) e.
/// Not finite where the body rests. Source: the chain rule, d/ds = (d/dt)/v.
[[nodiscard]] ORISPLINE_EXPORT PathShape path_shape(const Motion& motion) noexcept;

/// How far a quantity of a curve's shape jumps where its segments meet.
struct ShapeJump {
  double largest = 0.0;   ///< largest ‖right - left‖ at a key, in the unit of the quantity
  std::size_t key = 0;    ///< where
  double relative = 0.0;  ///< the largest over max(1, ‖left‖, ‖right‖); 0 where every jump is rounding
};

/// The geometric continuity G^k that a curve really has on its keys: that of its PathShape, which does not depend on
/// the time scale of a segment. At a rest the direction is the limit from either side, which goes by the first rate
/// that does not vanish; the curvature has none in general, so that a key where the body rests is G1 at most.
struct ORISPLINE_EXPORT ShapeContinuity {
  ShapeJump direction{};            ///< of e [1], at rests of its limits
  ShapeJump direction_in_motion{};  ///< of e [1], at the keys at which the body moves
  ShapeJump curvature{};            ///< of κ [1/rad], at these
  ShapeJump curvature_rate{};       ///< of dκ/ds [1/rad²], at these
  std::size_t joints = 0;           ///< keys that were looked at
  std::size_t rests = 0;            ///< of them those at which the body rests
  std::size_t first_rest = 0;       ///< the first of these, if there is one
  std::size_t stands = 0;           ///< of the rests those with no direction on one side, where the body stands still
  std::size_t first_stand = 0;      ///< the first of these, if there is one
  /// The order up to which a jump that matters could not hide in the rounding of the rates, at the keys at which the
  /// body moves.
  int told = 3;
  std::size_t hidden_at = 0;  ///< the first key at which more cannot be told, if there is one
  bool broken = false;        ///< the orientation jumps, so that there is no path

  /// The largest k up to `told` for which nothing of order k or lower jumps by more than `continuity_tolerance` at the
  /// keys at which the body moves; absent where it rests at all of them, or the orientation jumps.
  [[nodiscard]] std::optional<int> order_in_motion() const noexcept;
  /// The largest such k of all keys, 1 at most where the body rests at one of them; absent where it stands still
  /// beside a key, since no direction is defined there.
  [[nodiscard]] std::optional<int> order() const noexcept;
  /// The largest angle between the directions on both sides of a key [rad], and the key.
  [[nodiscard]] std::pair<double, std::size_t> corner() const noexcept;
  /// Whether the order may be higher than order() says, which double precision cannot tell.
  [[nodiscard]] bool is_hidden() const noexcept;
};

/// One-sided shapes compared at every interior key and, of a loop, at its seam (key 0). A body rests where its rate is
/// at most `continuity_tolerance` times the largest one. Jumps that the rounding of the rates explains are rounding. An
/// order is told where this is too small to hide a corner of 1e-3 rad, or a jump of 1 in 1/rad or 1/rad², by the turns
/// beside the key where these are smaller than 1 rad.
[[nodiscard]] ORISPLINE_EXPORT ShapeContinuity shape_continuity_at_keys(const AnyCurve& curve, Seam seam = Seam::open);

/// In time and of the shape.
struct Continuities {
  Continuity in_time{};
  ShapeContinuity of_shape{};
};

/// Both, from one look at every key.
[[nodiscard]] ORISPLINE_EXPORT Continuities continuities_at_keys(const AnyCurve& curve, Seam seam = Seam::open);

}}  // namespace orispline
