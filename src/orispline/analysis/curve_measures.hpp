// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/curve/curve.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How much a curve accelerates, summed over its segments.
///
/// Only what happens inside the segments counts: where ω jumps at a key the true ∫|α|² is infinite, where α jumps the
/// true ∫|jerk|² is (`continuity_at_keys` says which).
struct Energies {
  double acceleration = 0.0;  ///< ∫|α|² dt [rad²/s³]
  double jerk = 0.0;          ///< ∫|dα/dt|² dt [rad²/s⁵]
  double torque = 0.0;        ///< ∫|J α + ω × J ω|² dt [N² m² s]; the first one for unit inertia
};

/// By adaptive Gauss quadrature, to 1e-10 relative in each segment, whatever the epoch of the times.
///
/// A closed form exists only where a segment turns about a fixed axis (slerps, keys about one axis): there the rates of
/// the polynomial methods are polynomials of time, and one Gauss rule of ten points is that closed form, exact to
/// degree 19. With turning axes the integrands hold sines of the factors' angles, and no closed form is known.
[[nodiscard]] ORISPLINE_EXPORT Energies energies(const AnyCurve& curve,
                                                 const Eigen::Matrix3d& inertia = Eigen::Matrix3d::Identity());

/// With more keys the least energy is not looked for, which takes a quarter of a millisecond a key.
inline constexpr std::size_t most_keys_for_least_energy = 10000;

/// ∫|α|² dt [rad²/s³] of the method `least` through the orientations, with free ends and whatever rates the keys have.
/// Absent for fewer than two keys, for more than `most_keys_for_least_energy`, and where the optimum was not found.
[[nodiscard]] ORISPLINE_EXPORT std::optional<double> least_energy(const Keyframes& keys);

/// The largest length of a rate, and the first time when it is reached [s].
struct Peak {
  double value = 0.0, time = 0.0;
};

struct Peaks {
  Peak angular_velocity{};      ///< [rad/s]
  Peak angular_acceleration{};  ///< [rad/s²]
  Peak torque{};                ///< ‖J α + ω × J ω‖ [N m]; that of α for unit inertia
};

/// The peaks over the whole curve, the one-sided rates at the keys among them.
///
/// Each segment is searched in 16 steps; a maximum between two of them is found by bisection of the exact derivative
/// (ω·α, α·jerk, torque times its rate), to the rounding of time.
[[nodiscard]] ORISPLINE_EXPORT Peaks peaks(const AnyCurve& curve,
                                           const Eigen::Matrix3d& inertia = Eigen::Matrix3d::Identity());

/// The angle ∫|ω| dt that a curve has travelled [rad]: the arc length of orientations, and its inverse.
///
/// Made once per curve by adaptive Gauss quadrature, to 1e-10 relative in each segment (less where |ω| touches zero and
/// has a kink).
class ORISPLINE_EXPORT AngleTravelled {
 public:
  explicit AngleTravelled(AnyCurve curve);

  /// Of the whole curve [rad].
  [[nodiscard]] double total() const noexcept { return at_knots_.back(); }
  /// From the start to the time t [s], which is held to the domain [rad].
  [[nodiscard]] double at(double t) const;
  /// The first time [s] at which the curve has travelled that angle [rad], which is held to 0 … total().
  [[nodiscard]] double time_at(double angle) const;

 private:
  [[nodiscard]] double within(std::size_t segment, double start, double end) const;

  AnyCurve curve_;
  std::vector<double> at_knots_;  // [rad]
};

}}  // namespace orispline
