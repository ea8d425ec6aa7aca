// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/LU>

#include <orispline/math/eigen.hpp>

namespace orispline::testing_support {

/// Given velocities at the ends.
struct SplineEnds {
  std::optional<Eigen::Vector3d> start{}, end{};
};

/// The cubic ν-spline written down as it is defined, as one system for all coefficients: it passes through the points,
/// its velocity is continuous and its acceleration jumps at the inner ones by ν times the velocity; at an end there is
/// a given velocity or no acceleration.
class CubicSplineByDefinition {
 public:
  using Ends = SplineEnds;

  CubicSplineByDefinition(std::vector<double> times, const std::vector<Eigen::Vector3d>& points, Ends ends = {},
                          const std::vector<double>& nu = {})
      : times_(std::move(times)) {
    const Eigen::Index segments = static_cast<Eigen::Index>(times_.size()) - 1, size = 4 * segments;
    Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(size, size);
    Eigen::MatrixX3d values = Eigen::MatrixX3d::Zero(size, 3);
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < segments; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double h = times_[k + 1] - times_[k];
      equations.block<1, 4>(row, 4 * i) = derivative_row(0, 0.0);
      values.row(row++) = points[k];
      equations.block<1, 4>(row, 4 * i) = derivative_row(0, h);
      values.row(row++) = points[k + 1];
      if (i + 1 == segments) continue;
      equations.block<1, 4>(row, 4 * i) = derivative_row(1, h);
      equations.block<1, 4>(row++, 4 * i + 4) = -derivative_row(1, 0.0);
      equations.block<1, 4>(row, 4 * i) = -derivative_row(2, h);
      equations.block<1, 4>(row++, 4 * i + 4) =
          derivative_row(2, 0.0) - (nu.empty() ? 0.0 : nu[k + 1]) * derivative_row(1, 0.0);
    }
    const double last = times_[times_.size() - 1] - times_[times_.size() - 2];
    equations.block<1, 4>(row, 0) = derivative_row(ends.start ? 1 : 2, 0.0);
    if (ends.start) values.row(row) = *ends.start;
    ++row;
    equations.block<1, 4>(row, size - 4) = derivative_row(ends.end ? 1 : 2, last);
    if (ends.end) values.row(row) = *ends.end;
    coefficients_ = equations.fullPivLu().solve(values);
  }

  /// The k-th derivative at t on the segment, k ≤ 2.
  [[nodiscard]] Eigen::Vector3d derivative(int k, double t, std::size_t segment) const {
    return (derivative_row(k, t - times_[segment]) *
            coefficients_.block<4, 3>(4 * static_cast<Eigen::Index>(segment), 0))
        .transpose();
  }

 private:
  [[nodiscard]] static Eigen::RowVector4d derivative_row(int k, double x) {
    if (k == 0) return {1.0, x, x * x, x * x * x};
    if (k == 1) return {0.0, 1.0, 2.0 * x, 3.0 * x * x};
    return {0.0, 0.0, 2.0, 6.0 * x};
  }

  std::vector<double> times_;
  Eigen::MatrixX3d coefficients_;
};

}  // namespace orispline::testing_support
