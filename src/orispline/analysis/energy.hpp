// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/curve.hpp>

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

}}  // namespace orispline
