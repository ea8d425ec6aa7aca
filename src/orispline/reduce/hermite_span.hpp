// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/reduce/cubic_span.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What one span adds to the linear equations for the rates at its two ends.
struct HermiteEquations {
  Eigen::Matrix3d first = Eigen::Matrix3d::Zero(), mixed = Eigen::Matrix3d::Zero(), last = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_first = Eigen::Vector3d::Zero(), right_last = Eigen::Vector3d::Zero();
};

/// One span of `hermite-c1` from one target to another, and what it misses the targets between by.
///
/// With v = 1 - u and φ the whole turn it is ψ(u) = (3 - 2u) u² φ + h u v² ω₀ - h u² v J_r⁻¹(φ) ω₁ in the rotation
/// vector from its first key: linear in the body rates ω₀ and ω₁ of its ends. A target at the rotation vector φ_k is
/// missed by |J_r(φ_k) (ψ - φ_k)| but for terms of a higher order. Of positions the same without the Jacobians. Source:
/// our own derivation, docs/skeletons.md.
template <CurvePoint P>
class HermiteSpan {
 public:
  /// From target i to target j; whether all between have to be within the bound. Refers to the targets.
  HermiteSpan(const CubicTargets<P>& targets, std::size_t i, std::size_t j, bool is_bound);

  [[nodiscard]] std::size_t first() const noexcept { return first_; }
  [[nodiscard]] std::size_t last() const noexcept { return last_; }

  /// All targets count alike again.
  void reset_weights();
  /// The equations of the rates [rad/s, or lengths per second] with the least weighted sum of squared misses.
  [[nodiscard]] HermiteEquations equations() const;
  /// The largest square miss with these rates, of rotations the square of half the angle, but for terms of a higher
  /// order; 0 of a span that is not bound. Of a long span only some targets are looked at.
  double measure(const Eigen::Vector3d& rate_first, const Eigen::Vector3d& rate_last);
  /// Whether all targets are within the bound, those too that measure() does not look at; of rotations that of the
  /// square of half the angle's sine.
  [[nodiscard]] bool holds(const Eigen::Vector3d& rate_first, const Eigen::Vector3d& rate_last,
                           double square_bound) const;
  /// Every target's weight by its miss, as against the largest; those that are not bound count ever less.
  void weigh(double largest);

 private:
  /// A symmetric matrix: xx, yy, zz, xy, xz, yz.
  using Symmetric = Eigen::Array<double, 6, 1>;

  /// A target in the chart of the span.
  struct Term {
    double first, last;               ///< the basis of the rates: h u v² and -h u² v [s]
    Eigen::Vector3d rest;             ///< of the target, what the ends alone do not give
    Symmetric metric;                 ///< J_r(φ_k)ᵀ J_r(φ_k): what a miss across the turn's axis counts for
    Eigen::Vector3d right;            ///< of the equations: `metric` times `rest`
    double weight = 1.0, miss = 0.0;  ///< miss: square
  };

  [[nodiscard]] Term term_of(std::size_t target) const;
  [[nodiscard]] HermiteBasis basis_at(std::size_t target) const {
    return hermite_basis((targets_.times[target] - targets_.times[first_]) / length_);
  }

  const CubicTargets<P>& targets_;
  std::size_t first_, last_, every_;
  bool is_bound_;
  double length_;                                           ///< [s]
  Eigen::Vector3d turn_;                                    ///< from the first key to the last one, in the chart
  Eigen::Matrix3d to_chart_ = Eigen::Matrix3d::Identity();  ///< of the rate at the last key: J_r⁻¹(φ)
  std::vector<Term> terms_;
};

extern template class HermiteSpan<Eigen::Quaterniond>;
extern template class HermiteSpan<Eigen::Vector3d>;

/// Whether the first and the last of a row of rates may change.
struct FreeEnds {
  bool first = false, last = false;
};

/// The rates at the keys of a row of spans with the least squares of what they miss: a linear system of 3 by 3 blocks
/// around the diagonal.
template <CurvePoint P>
void fit_rates(std::span<HermiteSpan<P>* const> spans, std::span<Eigen::Vector3d> rates, FreeEnds free);

/// Rates with which all spans hold, where they are found: by least squares, and where the worst target is missed by
/// little, by further rounds that weigh each target by its miss (Lawson). The rates are those of the last round.
template <CurvePoint P>
[[nodiscard]] bool find_rates(std::span<HermiteSpan<P>* const> spans, std::span<Eigen::Vector3d> rates, FreeEnds free,
                              double square_bound);

}}  // namespace orispline
