// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The components of a point: qx, qy, qz, qw, or x, y, z.
template <CurvePoint P>
using Components = std::conditional_t<std::same_as<P, Eigen::Quaterniond>, Eigen::Vector4d, Eigen::Vector3d>;

/// The cubic Hermite basis at a local time u in [0, 1]: what the ends count for, and the derivatives there times the
/// length of the piece.
struct HermiteBasis {
  double start, leaving, arriving, end;
};

[[nodiscard]] constexpr HermiteBasis hermite_basis(double u) noexcept {
  const double v = 1.0 - u;
  return {
      .start = v * v * (1.0 + 2.0 * u), .leaving = u * v * v, .arriving = -u * u * v, .end = u * u * (1.0 + 2.0 * v)};
}

/// Misses farther than this many tolerances are not brought within it by weights.
inline constexpr double beyond_weights = 2.0;

/// Points at times that cubics are fitted to. Quaternions have their signs for the shorter way from one to the next.
template <CurvePoint P>
struct CubicTargets {
  std::vector<double> times;          ///< [s], rising
  std::vector<Components<P>> points;  ///< one each
};

/// The derivatives of a cubic at its two ends, component by component [1/s].
template <CurvePoint P>
struct CubicTangents {
  Components<P> leaving = Components<P>::Zero(), arriving = Components<P>::Zero();
};

/// Tangents that are given, if any.
template <CurvePoint P>
struct GivenTangents {
  std::optional<Components<P>> leaving{}, arriving{};

  [[nodiscard]] bool any() const noexcept { return leaving || arriving; }
};

/// Cubic Hermite polynomials of the components, of quaternions normalised, with free tangents: whether one of them,
/// from one target to another, is within the tolerance of all between.
///
/// The tangents are found by linear least squares. What a quaternion's radius should be is not known: each round scales
/// the targets to the lengths that the polynomial had there. These rounds go slowly where it should be far from 1; then
/// the misses across the targets alone are made least, for all components at once, with lengths from a half to 2. Where
/// the worst target is missed by little, further rounds weigh each target by its miss (Lawson), which leads towards the
/// tangents that miss the worst one least; they end where the weighted mean of the squares, which no tangents make
/// smaller, is above the bound.
/// A span turns by 180° at most. Source: our own derivation, docs/skeletons.md.
template <CurvePoint P>
class CubicSpans {
 public:
  /// The tolerance is an angle [rad] or a length. Refers to the targets.
  CubicSpans(const CubicTargets<P>& targets, double tolerance);
  CubicSpans(CubicTargets<P>&&, double) = delete;

  /// Tangents with which the cubic from target i to target j holds all between, those that are given among them;
  /// nothing where none were found.
  [[nodiscard]] std::optional<CubicTangents<P>> within(std::size_t i, std::size_t j,
                                                       const GivenTangents<P>& given = {}) const;
  /// Those of least squares, whatever they miss.
  [[nodiscard]] CubicTangents<P> nearest(std::size_t i, std::size_t j, const GivenTangents<P>& given = {}) const;

 private:
  class Fit;

  /// within() by every so many-th target.
  [[nodiscard]] std::optional<CubicTangents<P>> within(std::size_t i, std::size_t j, const GivenTangents<P>& given,
                                                       std::size_t every) const;
  /// Whether that cubic holds all between.
  [[nodiscard]] bool holds(std::size_t i, std::size_t j, const CubicTangents<P>& tangents) const;

  const CubicTargets<P>& targets_;
  double square_bound_;  ///< of the miss, in the terms of the fit
};

extern template class CubicSpans<Eigen::Quaterniond>;
extern template class CubicSpans<Eigen::Vector3d>;

}}  // namespace orispline
