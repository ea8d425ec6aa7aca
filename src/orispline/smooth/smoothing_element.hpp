// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One segment of a smoothing curve: the polynomial ψ of degree 2P-1 in the chart at its middle, from -φ/2 to φ/2, that
/// has the body rates of both ends.
///
/// Its residual e has |e|² = ∫|ψ^(P)|² dt: Legendre moments of that derivative. P = 2 takes ω at the ends, P = 3 takes
/// ω and α. Our own derivation, docs/smooth.md.
template <int P>
struct SmoothingElement {
  static constexpr int unknowns = 3 * P;  ///< of a node: turn, ω [, α]
  using Rates = Eigen::Matrix<double, unknowns - 3, 1>;
  using Residual = Eigen::Matrix<double, unknowns, 1>;
  using Jacobian = Eigen::Matrix<double, unknowns, 2 * unknowns>;

  struct Linearised {
    Residual residual;
    Jacobian jacobian;  ///< by turn and rates of the first node, then of the second; turns as q exp(x)
  };

  /// Of the step φ [rad] with these rates at its ends, which take h [s].
  [[nodiscard]] static Residual residual(const Eigen::Vector3d& step, const Rates& leaving, const Rates& arriving,
                                         double h);
  [[nodiscard]] static Linearised linearised(const Eigen::Vector3d& step, const Rates& leaving, const Rates& arriving,
                                             double h);
};

extern template struct SmoothingElement<2>;
extern template struct SmoothingElement<3>;

/// The step between two orientations [rad], at most π long whatever their signs, in the body frame.
[[nodiscard]] inline Eigen::Vector3d shortest_increment(const Eigen::Quaterniond& from,
                                                        const Eigen::Quaterniond& to) noexcept {
  Eigen::Quaterniond step = from.conjugate() * to;
  if (step.w() < 0.0) step.coeffs() = -step.coeffs();
  return log<double>(step);
}

/// P = 2: α [rad/s²] at every node, the mean of those of the polynomials on both sides, which agree to second order in
/// the step at a minimum without a gyro. `steps` [rad] are those between successive nodes, `rates` [rad/s] at all of
/// them.
[[nodiscard]] std::vector<Eigen::Vector3d> mean_accelerations(std::span<const double> times,
                                                              std::span<const Eigen::Vector3d> steps,
                                                              std::span<const Eigen::Vector3d> rates);

}}  // namespace orispline
