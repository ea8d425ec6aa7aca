// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <variant>

#include <orispline/batch/compile_segment.hpp>
#include <orispline/curve/curve.hpp>

namespace orispline::testing_support {

/// How large the terms get of which a segment is made: bounds from its Bernstein coefficients. All zero for a segment
/// that is left to the scalar evaluator, whose samples must be that evaluator's own.
struct SegmentSize {
  double angle = 0.0;     ///< of any factor [rad]
  double velocity = 0.0;  ///< sum of the factors' own rates [rad/s]
  // The same with the products of rates; and the angles over as many powers of the segment's length: coefficients are
  // rounded as they are large, also where their differences are small.
  double acceleration = 0.0;  ///< [rad/s²]
  double jerk = 0.0;          ///< [rad/s³]
};

/// Largest coefficient of the derivative of that order in u, of a polynomial whose coefficients have a norm.
template <class Coefficients, class Norm>
[[nodiscard]] double largest_derivative(Coefficients c, std::size_t degree, std::size_t order, Norm norm) {
  for (std::size_t d = 0; d < order; ++d)
    for (std::size_t i = 0; i + d < degree; ++i) c[i] = static_cast<double>(degree - d) * (c[i + 1] - c[i]);
  double largest = 0.0;
  for (std::size_t i = 0; i + order <= degree; ++i) largest = std::max(largest, norm(c[i]));
  return largest;
}

/// `bound(order)` is the largest derivative of the factor's angle in u, h the segment's length [s].
template <class Bound>
void add_factor(SegmentSize& size, double h, Bound bound) {
  size.angle = std::max(size.angle, bound(0));
  size.velocity += bound(1) / h;
  size.acceleration += (bound(0) + bound(2)) / (h * h);
  size.jerk += (bound(0) + bound(3)) / (h * h * h);
}

[[nodiscard]] inline SegmentSize size_of(const AnyCurve& curve, std::size_t segment) {
  SegmentSize size;
  if (curve.knots().segments() == 0) return size;
  const SegmentForm form = curve.form(segment);
  const double h = curve.knots().span(segment).step();
  if (const auto* cumulative = std::get_if<CumulativeForm>(&form)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto norm = [phi = cumulative->increments[k].norm()](double c) { return phi * std::abs(c); };
      add_factor(size, h, [&](std::size_t order) {
        return largest_derivative(cumulative->blending[k].coefficients, cumulative->degree, order, norm);
      });
    }
  } else if (const auto* chart = std::get_if<ChartForm>(&form)) {
    std::array<Eigen::Vector3d, form_degree + 1> psi;
    for (std::size_t i = 0; i <= form_degree; ++i)
      psi[i] = {chart->rotation_vector[0].coefficients[i], chart->rotation_vector[1].coefficients[i],
                chart->rotation_vector[2].coefficients[i]};
    const auto norm = [](const Eigen::Vector3d& c) { return c.norm(); };
    add_factor(size, h, [&](std::size_t order) { return largest_derivative(psi, chart->degree, order, norm); });
  } else if (const auto* rational = std::get_if<RationalForm>(&form)) {
    std::array<Eigen::Vector4d, 4> c;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) c[i][static_cast<Eigen::Index>(k)] = rational->components[k].coefficients[i];
    const Eigen::Vector4d along = (c[0] + c[3]).normalized();
    const double least = std::min({c[0].dot(along), c[1].dot(along), c[2].dot(along), c[3].dot(along)});
    const auto norm = [](const Eigen::Vector4d& v) { return v.norm(); };
    const auto bound = [&](std::size_t order) { return largest_derivative(c, 3, order, norm) / least; };
    if (!(least > 0.0 && bound(0) <= batch::largest_rational_spread)) return size;
    add_factor(size, h, [&](std::size_t order) { return order == 0 ? bound(0) : 2.0 * bound(order); });
  }
  size.jerk += size.velocity * (3.0 * size.acceleration + size.velocity * size.velocity);
  size.acceleration += size.velocity * size.velocity;
  return size;
}

/// Allowed differences from the scalar evaluator, per max(1, angle) and max(1, size of the rate).
struct Limits {
  double orientation, velocity, acceleration, jerk;
};
template <class T>
[[nodiscard]] Limits limits();

/// Orientation: the promise. The rates: both evaluators sum some dozens of terms within the bounds; and where Bernstein
/// coefficients differ little from each other, their differences keep the rounding of the coefficients themselves, of
/// which the second derivative takes up to n (n - 1) = 42 times, the third 210 times: measured at worst 14, 55 and 516
/// units. In float only the polynomials' own rounding counts, the coefficients come from double.
template <>
[[nodiscard]] inline Limits limits<double>() {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  return {4.0 * unit, 32.0 * unit, 128.0 * unit, 1024.0 * unit};
}
template <>
[[nodiscard]] inline Limits limits<float>() {
  return {3e-7, 6e-7, 12e-7, 6e-7};
}

}  // namespace orispline::testing_support
