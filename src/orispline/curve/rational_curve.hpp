// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/curve/motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A cubic of R⁴ from one key to the next, as qx, qy, qz, qw: its ends, and the steps from control point to control
/// point, which keep their digits where keys lie close together.
struct RationalPiece {
  Eigen::Vector4d start, end;
  std::array<Eigen::Vector4d, 3> steps;

  /// The control points of the Bernstein form.
  [[nodiscard]] std::array<Eigen::Vector4d, 4> controls() const noexcept {
    return {start, start + steps[0], end - steps[2], end};
  }
};

/// The body rates of s/|s| for any s(t) in R⁴ with its derivatives in t.
///
/// With w = 2 vec(s̄ ṡ) and n = |s|², both differentiated as they stand, n ω = w.
[[nodiscard]] inline Motion motion_of_direction(const std::array<Eigen::Vector4d, 4>& s) noexcept {
  const auto twice_between = [&s](std::size_t a, std::size_t b) -> Eigen::Vector3d {
    return 2.0 * (Eigen::Quaterniond(s[a]).conjugate() * Eigen::Quaterniond(s[b])).vec();
  };
  const double square = s[0].squaredNorm();
  Motion m{.orientation = Eigen::Quaterniond(Eigen::Vector4d(s[0] / std::sqrt(square))),
           .angular_velocity = twice_between(0, 1) / square};
  const double growth = 2.0 * s[0].dot(s[1]), growth_rate = 2.0 * (s[1].squaredNorm() + s[0].dot(s[2]));
  m.angular_acceleration = (twice_between(0, 2) - growth * m.angular_velocity) / square;
  m.angular_jerk = (twice_between(0, 3) + twice_between(1, 2) -
                    (2.0 * growth * m.angular_acceleration + growth_rate * m.angular_velocity)) /
                   square;
  return m;
}

/// A piecewise cubic curve of R⁴ that does not pass through 0, normalised: q = s/|s|.
class RationalCurve {
 public:
  RationalCurve(Knots knots, std::vector<RationalPiece> pieces) : knots_(std::move(knots)), pieces_(std::move(pieces)) {
    ORISPLINE_EXPECT(pieces_.size() == knots_.segments());
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }

  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    const Vector4<T> s = spatial(knots_.span(segment).normalised(t), pieces_[segment]);
    return Quaternion<T>(Vector4<T>(s / sqrt_of(T(s.squaredNorm()))));
  }

  [[nodiscard]] Motion motion(double t, std::size_t segment) const noexcept {
    const KnotSpan span = knots_.span(segment);
    const RationalPiece& p = pieces_[segment];
    const double u = span.normalised(t), v = 1.0 - u, rate = 1.0 / span.step();
    const auto& [first, middle, last] = p.steps;
    const Eigen::Vector4d bend = middle - first, next_bend = last - middle;
    return motion_of_direction({spatial(u, p), 3.0 * rate * (v * v * first + 2.0 * u * v * middle + u * u * last),
                                6.0 * rate * rate * (v * bend + u * next_bend),
                                6.0 * rate * rate * rate * (next_bend - bend)});
  }

  /// The segment as polynomials.
  [[nodiscard]] SegmentForm form(std::size_t segment) const noexcept {
    RationalForm form;
    const auto controls = pieces_[segment].controls();
    for (std::size_t i = 0; i < controls.size(); ++i)
      for (std::size_t k = 0; k < form.components.size(); ++k)
        form.components[k].coefficients[i] = controls[i][static_cast<Eigen::Index>(k)];
    return form;
  }

 private:
  template <Number T>
  [[nodiscard]] static Vector4<T> spatial(const T& u, const RationalPiece& p) noexcept {
    const T v = T(1.0) - u, u2 = u * u, v2 = v * v;
    const T of_start = v2 * (T(1.0) + u * Plain<T>(2.0)), of_end = u2 * (T(1.0) + v * Plain<T>(2.0));
    const T leaving = u * v2 * Plain<T>(3.0), arriving = u2 * v * Plain<T>(3.0);
    Vector4<T> s;
    for (Eigen::Index k = 0; k < 4; ++k)
      s[k] = of_start * Plain<T>(p.start[k]) + of_end * Plain<T>(p.end[k]) + leaving * Plain<T>(p.steps[0][k]) -
             arriving * Plain<T>(p.steps[2][k]);
    return s;
  }

  Knots knots_;
  std::vector<RationalPiece> pieces_;
};

}}  // namespace orispline
