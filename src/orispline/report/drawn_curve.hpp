// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <orispline/math/bernstein.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// A sample of a curve as the page has it, in the precision of its data.
struct DrawnSample {
  double time = 0.0;                                                ///< [s]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< [rad/s], body
};

/// How the page draws a curve between its samples.
enum class DrawnWay {
  cubic,     ///< with the angular velocities of the samples
  straight,  ///< the shortest way, where noise makes these useless
};

/// What the page draws from one sample to the next: the cubic with their orientations and angular velocities, or the
/// arc.
///
/// q(u) = q₀ exp(β̃₁(u) h ω₀/3) exp(β̃₂(u) λ) exp(β̃₃(u) h ω₁/3), λ the shortest one that ends it in q₁, with cumulative
/// Bernstein polynomials. studio/ has the same formula.
/// Source: Kim, Kim & Shin 1995, section 4.2 (the Hermite curve).
class DrawnSpan {
 public:
  /// Precondition: the second sample is later.
  DrawnSpan(const DrawnSample& from, const DrawnSample& to, DrawnWay way)
      : start_(from.time), step_(to.time - from.time), way_(way), base_(from.orientation) {
    if (way == DrawnWay::cubic) {
      increments_[0] = from.angular_velocity * (step_ / 3.0);
      increments_[2] = to.angular_velocity * (step_ / 3.0);
    }
    Eigen::Quaterniond left =
        (base_ * exp<double>(increments_[0])).conjugate() * (to.orientation * exp<double>(increments_[2]).conjugate());
    if (left.w() < 0.0) left.coeffs() = -left.coeffs();
    increments_[1] = log<double>(left);
  }

  [[nodiscard]] Eigen::Quaterniond operator()(double time) const noexcept {
    const double u = (time - start_) / step_;
    if (way_ == DrawnWay::straight) return base_ * exp<double>(u * increments_[1]);
    const auto basis = cumulative_bernstein_basis<3>(u);
    return displaced_in_turn<double, 3>(
        base_, {Eigen::Vector3d(basis[0] * increments_[0]), Eigen::Vector3d(basis[1] * increments_[1]),
                Eigen::Vector3d(basis[2] * increments_[2])});
  }

 private:
  double start_, step_;
  DrawnWay way_;
  Eigen::Quaterniond base_;
  std::array<Eigen::Vector3d, 3> increments_{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

}}}  // namespace orispline::report
