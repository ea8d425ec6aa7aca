// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/curve/curve.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>

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

/// By adaptive Gauss–Kronrod quadrature, to 1e-10 relative in each segment, whatever the epoch of the times.
///
/// A closed form exists only where a segment turns about a fixed axis (slerps, keys about one axis): there the rates of
/// the polynomial methods are polynomials of time, and the rule of 21 points is that closed form, exact to degree 31.
/// With turning axes the integrands hold sines of the factors' angles, and no closed form is known.
[[nodiscard]] ORISPLINE_EXPORT Energies energies(const AnyCurve& curve,
                                                 const Eigen::Matrix3d& inertia = Eigen::Matrix3d::Identity());

/// With more keys the least energy is not looked for, which takes a quarter of a millisecond a key.
inline constexpr std::size_t most_keys_for_least_energy = 10000;

/// ∫|α|² dt [rad²/s³] of the method `least` through the orientations, with free ends and whatever rates the keys have.
/// Absent for fewer than two keys, for more than `most_keys_for_least_energy`, and where the optimum was not found.
[[nodiscard]] ORISPLINE_EXPORT std::optional<double> least_energy(const Keyframes& keys);

/// The largest length of a rate that was found, and a time when it is reached [s].
struct Peak {
  double value = 0.0, time = 0.0;
  /// What the rate is nowhere above, absent where no bound is known.
  std::optional<double> bound{};
};

struct Peaks {
  Peak angular_velocity{};      ///< [rad/s]
  Peak angular_acceleration{};  ///< [rad/s²]
  Peak torque{};                ///< ‖J α + ω × J ω‖ [N m]; that of α for unit inertia
};

/// The peaks over the whole curve, the one-sided rates at the keys among them.
///
/// Segments that are stated as polynomials have bounds (`SegmentHull`): each step that may hold more than was found is
/// cut, the worst first, until no bound is more than 1e-3 above the largest value found, rounding apart. For other
/// segments no bound is known: they are cut where the rates differ from the cubics between the steps or the body turns
/// by more than 0.2 rad on one, and towards keys with far shorter steps beside; of a curve that may turn by more than
/// 1e4 rad not all maxima are found so. A maximum between two steps is found by bisection of the exact derivative (ω·α,
/// α·jerk, torque times its rate), to the rounding of time.
[[nodiscard]] ORISPLINE_EXPORT Peaks peaks(const AnyCurve& curve,
                                           const Eigen::Matrix3d& inertia = Eigen::Matrix3d::Identity());

/// How far a curve has gone, its arc length, and the inverse of that: the angle ∫|ω| dt of orientations [rad], the
/// distance ∫|v| dt of positions [m].
///
/// Made once per curve by adaptive Gauss–Kronrod quadrature, to 1e-10 relative in each segment, also where the speed
/// touches zero and has a kink; less on curves that turn thousands of times between two keys.
template <class C>
class ORISPLINE_EXPORT ArcLength {
 public:
  /// `kinks`: times inside its segments at which its speed touches zero, in order [s]; stated, they cost no accuracy.
  explicit ArcLength(C curve, std::span<const double> kinks = {});

  /// Of the whole curve.
  [[nodiscard]] double total() const noexcept { return lengths_.back(); }
  /// From the start to the time t [s], which is held to the domain.
  [[nodiscard]] double at(double t) const;
  /// The first time [s] at which the curve has gone so far, which is held to 0 … total().
  [[nodiscard]] double time_at(double length) const;

 private:
  /// From a node on, to a time before the next one.
  [[nodiscard]] double beyond(std::size_t node, double end) const;

  C curve_;
  double rounding_;              // of lengths
  std::vector<double> nodes_;    // knots and kinks [s]
  std::vector<double> lengths_;  // from the start to each of them
};

extern template class ArcLength<AnyCurve>;
extern template class ArcLength<AnyPath>;

using AngleTravelled = ArcLength<AnyCurve>;
using DistanceTravelled = ArcLength<AnyPath>;

}}  // namespace orispline
