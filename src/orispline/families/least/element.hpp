// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/curve/chart_ends.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// What a curve is to have the least of.
enum class LeastOf { acceleration, torque, jerk };

/// Sums of squares of the columns of turn, ω and α of a node: what damping is relative to, whatever the frame.
template <class Columns>
[[nodiscard]] Eigen::Array3d damping_weights(const Columns& columns) {
  return {columns.template middleCols<3>(0).squaredNorm(), columns.template middleCols<3>(3).squaredNorm(),
          columns.template middleCols<3>(6).squaredNorm()};
}

/// One piece of a curve of least energy: the quintic ψ in the chart at its middle, from -φ/2 to φ/2, that has ω and α
/// of both ends.
///
/// Its residual e has |e|² = ∫|f|² dt by a Gauss rule, f the body's α, its torque or its jerk.
template <LeastOf F>
struct LeastElement {
  static constexpr int gauss_points = 4;
  static constexpr int rows = 3 * gauss_points;
  static constexpr int unknowns = 9;  ///< of a node: turn, ω, α
  using Rates = ChartEnd<3>;
  using Residual = Eigen::Matrix<double, rows, 1>;
  using Jacobian = Eigen::Matrix<double, rows, 2 * unknowns>;

  struct Linearised {
    Residual residual;
    Jacobian jacobian;  ///< by turn, ω and α of the first node, then of the second; turns as q exp(x)
  };

  /// Half the energy's derivatives of both orders by the same unknowns.
  struct Curved {
    Eigen::Matrix<double, 2 * unknowns, 1> gradient;
    Eigen::Matrix<double, 2 * unknowns, 2 * unknowns> hessian;
    std::array<Eigen::Array3d, 2> weights;  ///< damping_weights() of the Jacobian for both nodes
  };

  /// Of the step φ [rad] with these rates at its ends, which take h [s]. `inertia` [kg m²] is for the torque.
  [[nodiscard]] static Residual residual(const Eigen::Vector3d& step, const Rates& leaving, const Rates& arriving,
                                         double h, const Eigen::Matrix3d& inertia);
  [[nodiscard]] static Linearised linearised(const Eigen::Vector3d& step, const Rates& leaving, const Rates& arriving,
                                             double h, const Eigen::Matrix3d& inertia);
  /// In closed form but for the last derivative, which is by duals. Costs some five times as much.
  [[nodiscard]] static Curved curved(const Eigen::Vector3d& step, const Rates& leaving, const Rates& arriving, double h,
                                     const Eigen::Matrix3d& inertia);
};

extern template struct LeastElement<LeastOf::acceleration>;
extern template struct LeastElement<LeastOf::torque>;
extern template struct LeastElement<LeastOf::jerk>;

}}}  // namespace orispline::families
