// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/segment_residuals.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/analysis/rounding.hpp>
#include <orispline/curve/cumulative_bezier.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/slerp_bezier.hpp>
#include <orispline/math/bernstein.hpp>
#include <orispline/math/gauss_legendre.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t exact_nodes = 6;  // of the square of a second derivative, whose degree is 10
constexpr std::size_t nodes = 20;
constexpr std::size_t nodes_of_shape = 48;  // of what is divided by a power of the rate

/// The Bernstein polynomials of degree `form_degree` at one place, as Taylor series in u.
using BasisAt = std::array<Jet<double, 3>, form_degree + 1>;

struct Node {
  double u, weight;
  BasisAt basis;
};

BasisAt basis_at(double u) { return bernstein_basis<form_degree>(Jet<double, 3>::variable(u)); }

template <std::size_t N>
std::array<Node, N> quadrature() {
  std::array<Node, N> result;
  const auto rule = gauss_legendre<N>();
  for (std::size_t i = 0; i < N; ++i) result[i] = {rule[i].u, rule[i].weight, basis_at(rule[i].u)};
  return result;
}

std::span<const Node> quadrature_of(Objective objective) {
  static const auto exact = quadrature<exact_nodes>();
  static const auto fine = quadrature<nodes>();
  static const auto finest = quadrature<nodes_of_shape>();
  if (objective == Objective::curvature) return finest;
  return objective == Objective::linearised ? std::span<const Node>(exact) : std::span<const Node>(fine);
}

/// Bernstein coefficients over a number that knows how they change along one variable.
template <Number T>
using RowsOver = std::array<std::array<T, form_degree + 1>, 3>;

BlendingRows rows_at(const TensionSegment& segment, std::span<const double> values) {
  BlendingRows rows = segment.constant;
  for (std::size_t v = 0; v < values.size(); ++v)
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (std::size_t j = 0; j <= form_degree; ++j)
        rows[k].coefficients[j] += values[v] * segment.slopes[v][k].coefficients[j];
  return rows;
}

/// What a segment is made of at some values of its variables.
template <Number T>
struct Shape {
  RowsOver<T> rows;
  std::array<Vector3<T>, 3> increments;
  Quaternion<T> from;
  Vector3<T> correction = Vector3<T>::Zero();  ///< where the segment has one
};

/// Of all corrections.
std::span<const double, form_degree + 1> correction_row() {
  static const BernsteinForm form = correction_form();
  return form.coefficients;
}

template <Number T>
RowsOver<T> constant_rows(const BlendingRows& rows) {
  RowsOver<T> result;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t j = 0; j <= form_degree; ++j) result[k][j] = T(rows[k].coefficients[j]);
  return result;
}

template <Number T>
std::array<Vector3<T>, 3> constant_increments(const TensionSegment& s) {
  return {constant<T>(s.increments[0]), constant<T>(s.increments[1]), constant<T>(s.increments[2])};
}

Vector3<Jet<double, 1>> along(const Eigen::Vector3d& value, const Eigen::Vector3d& slope) {
  Vector3<Jet<double, 1>> result;
  for (Eigen::Index axis = 0; axis < 3; ++axis) result[axis].c = {value[axis], slope[axis]};
  return result;
}

/// An orientation that turns by this rotation vector per unit of a variable.
Quaternion<Jet<double, 1>> along(const Eigen::Quaterniond& q, const Eigen::Vector3d& turn) {
  return constant<Jet<double, 1>>(q) * exp<Jet<double, 1>>(along(Eigen::Vector3d::Zero(), turn));
}

std::array<Vector3<Jet<double, 1>>, 3> along(const Increments& increments, const Increments& slope) {
  std::array<Vector3<Jet<double, 1>>, 3> result;
  for (std::size_t k = 0; k < increments.size(); ++k) result[k] = along(increments[k], slope[k]);
  return result;
}

RowsOver<Jet<double, 1>> along(const BlendingRows& rows, const BlendingRows& slope) {
  RowsOver<Jet<double, 1>> result;
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t j = 0; j <= form_degree; ++j) result[k][j].c = {rows[k].coefficients[j], slope[k].coefficients[j]};
  return result;
}

/// β̃ in time, from the Taylor series of the Bernstein polynomials in u.
template <Number T, class Row>
Jet<T, 3> blending(const Row& row, const BasisAt& basis, double step) {
  Jet<T, 3> b;
  double scale = 1.0;
  for (std::size_t m = 0; m < 4; ++m) {
    for (std::size_t j = 0; j <= form_degree; ++j) b.c[m] += T(row[j]) * (basis[j].c[m] * scale);
    scale /= step;
  }
  return b;
}

/// The three arcs of a cubic of slerps, from the slopes of its chart at the two keys.
template <Number T>
MotionOver<T> slerp_motion(const TensionSegment& s, const Shape<T>& shape, const Jet<T, 3>& u) {
  const double third = static_cast<double>(form_degree) / 3.0;
  const Quaternion<T> from = constant<T>(s.from), to = constant<T>(s.to);
  const Quaternion<T> leaving = from * exp<T>(shape.increments[0] * T(shape.rows[0][1] * third));
  const Quaternion<T> arriving = to * exp<T>(shape.increments[2] * T(shape.rows[2][form_degree - 1] * third));
  using J = Jet<T, 3>;
  const auto in_time = [](const auto& q) { return Quaternion<J>(J(q.w()), J(q.x()), J(q.y()), J(q.z())); };
  const auto arc = [](const auto& a, const auto& b) -> Vector3<J> { return increment<T>(a, b).template cast<J>(); };
  return motion_from_jet<T>(slerp_cubic<J>({in_time(from), in_time(leaving), in_time(arriving)},
                                           {arc(from, leaving), arc(leaving, arriving), arc(arriving, to)}, u));
}

/// The cumulative cubic of the same handles, whose middle factor closes the gap between them.
template <Number T>
MotionOver<T> bezier_motion(const TensionSegment& s, const Shape<T>& shape, const Jet<T, 3>& u) {
  const double third = static_cast<double>(form_degree) / 3.0;
  const Quaternion<T> from = constant<T>(s.from), to = constant<T>(s.to);
  const Vector3<T> leaving = shape.increments[0] * T(shape.rows[0][1] * third);
  const Vector3<T> arriving = shape.increments[2] * T(shape.rows[2][form_degree - 1] * -third);
  const Vector3<T> between = increment<T>(from * exp<T>(leaving), to * exp<T>(Vector3<T>(-arriving)));
  MotionOver<T> m{.orientation = from};
  const auto blending = CubicBezierBasis::at(u);
  m = with_factor<T>(m, leaving, blending[0]);
  m = with_factor<T>(m, between, blending[1]);
  return with_factor<T>(m, arriving, blending[2]);
}

template <Number T>
MotionOver<T> motion_at(const TensionSegment& s, const Shape<T>& shape, const BasisAt& basis, double u) {
  if (s.product != TensionSegment::Product::cumulative) {
    Jet<T, 3> time(T{u});
    time.c[1] = T(1.0 / s.step);
    return s.product == TensionSegment::Product::slerps ? slerp_motion<T>(s, shape, time)
                                                        : bezier_motion<T>(s, shape, time);
  }
  MotionOver<T> m{.orientation = shape.from};
  for (std::size_t k = 0; k < shape.rows.size(); ++k)
    m = with_factor<T>(m, shape.increments[k], blending<T>(shape.rows[k], basis, s.step));
  if (s.correction) m = with_factor<T>(m, shape.correction, blending<T>(correction_row(), basis, s.step));
  return m;
}

/// Σ β̃_k'' φ_k.
template <Number T>
Vector3<T> linearised(const Shape<T>& shape, const BasisAt& basis, double step) {
  Vector3<T> sum = shape.correction * T(blending<double>(correction_row(), basis, step).derivative(2));
  for (std::size_t k = 0; k < shape.rows.size(); ++k) {
    T second(0.0);
    for (std::size_t j = 0; j <= form_degree; ++j) second += shape.rows[k][j] * basis[j].c[2];
    sum += shape.increments[k] * T(second * (2.0 / (step * step)));
  }
  return sum;
}

/// α⊥/|ω|^{3/2}, the square of which is |κ|² ds/dt; where the body rests nothing is travelled.
template <Number T>
Vector3<T> bending(const MotionOver<T>& m) {
  const Vector3<T>&w = m.angular_velocity, &a = m.angular_acceleration;
  const T square = w.squaredNorm();
  if (value_of(square) == 0.0) return Vector3<T>::Zero();
  const T rate = sqrt_of(square);
  return (a - w * T(a.dot(w) / square)) * T(T(1.0) / (rate * sqrt_of(rate)));
}

template <Number T>
Vector3<T> measured(const Goal& goal, const MotionOver<T>& m) {
  if (goal.objective == Objective::acceleration) return m.angular_acceleration;
  if (goal.objective == Objective::jerk) return m.angular_jerk;
  if (goal.objective == Objective::curvature) return bending<T>(m);
  return torque<T>(m, goal.inertia);
}

/// Calls `take(i, residual)` for every triple of residuals.
template <Number T, class Take>
void each_residual(const TensionSegment& s, const Goal& goal, std::size_t index, const Shape<T>& shape, Take take) {
  std::size_t i = 0;
  if (goal.objective == Objective::fit) {
    const double weight = 1.0 / std::sqrt(static_cast<double>(goal.sample_count));
    for (const ReferenceSample& seen : goal.reference_samples[index]) {
      const Quaternion<T> q = motion_at<T>(s, shape, basis_at(seen.u), seen.u).orientation;
      const Quaternion<T> from = constant<T>(seen.orientation);
      const bool same_side = value_of(q.dot(from)) >= 0.0;
      const Quaternion<T> nearer = same_side ? from : Quaternion<T>(-from.coeffs());
      take(i++, Vector3<T>(increment<T>(nearer, q) * T(weight)));
    }
    return;
  }
  for (const Node& node : quadrature_of(goal.objective)) {
    const T weight(std::sqrt(node.weight * s.step));
    const Vector3<T> value = goal.objective == Objective::linearised
                                 ? linearised<T>(shape, node.basis, s.step)
                                 : measured<T>(goal, motion_at<T>(s, shape, node.basis, node.u));
    take(i++, Vector3<T>(value * weight));
  }
}

Eigen::Index first_of(std::size_t triple) { return 3 * static_cast<Eigen::Index>(triple); }

/// One column per variable; `shape_along(v)` knows how the segment changes with variable v.
template <class ShapeAlong>
Eigen::MatrixXd jacobian_of(const TensionSegment& segment, const Goal& goal, std::size_t index, std::size_t variables,
                            ShapeAlong shape_along) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(residual_count(goal, index)), static_cast<Eigen::Index>(variables));
  for (std::size_t v = 0; v < variables; ++v)
    each_residual<Jet<double, 1>>(segment, goal, index, shape_along(v),
                                  [&](std::size_t i, const Vector3<Jet<double, 1>>& r) {
                                    for (Eigen::Index axis = 0; axis < 3; ++axis)
                                      result(first_of(i) + axis, static_cast<Eigen::Index>(v)) = r[axis].c[1];
                                  });
  return result;
}

}  // namespace

double rounding_of(const Goal& goal, const Keyframes& keys) noexcept {
  if (goal.objective == Objective::fit) return rounding_of_increments * rounding_of_increments;
  const int order = goal.objective == Objective::jerk ? 3 : 2;
  const double moment = goal.objective == Objective::torque ? goal.inertia.norm() : 1.0;
  const auto times = keys.times();
  const auto step = [&](std::size_t i) { return times[i + 1] - times[i]; };
  // Of the curvature, for a body that turns as fast as from key to key; where it does not turn there is no path.
  const auto weight = [&](std::size_t i) {
    if (goal.objective != Objective::curvature) return 1.0;
    const double rate = angular_distance(keys.orientations()[i], keys.orientations()[i + 1]) / step(i);
    return rate > rounding_of_rates(step(i), 1) ? 1.0 / (rate * rate * rate) : 0.0;
  };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    double shortest = step(i);
    if (i > 0) shortest = std::min(shortest, step(i - 1));
    if (i + 2 < times.size()) shortest = std::min(shortest, step(i + 1));
    const double rate = moment * rounding_of_rates(shortest, order);
    sum += step(i) * rate * rate * weight(i);
  }
  return sum;
}

std::size_t residual_count(const Goal& goal, std::size_t segment) {
  return 3 * (goal.objective == Objective::fit ? goal.reference_samples[segment].size()
                                               : quadrature_of(goal.objective).size());
}

Eigen::VectorXd residual_values(const TensionSegment& segment, const Goal& goal, std::size_t index,
                                std::span<const double> values) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(residual_count(goal, index)));
  each_residual<double>(
      segment, goal, index,
      Shape<double>{constant_rows<double>(rows_at(segment, values)), constant_increments<double>(segment), segment.from,
                    segment.correction.value_or(Eigen::Vector3d::Zero())},
      [&](std::size_t i, const Eigen::Vector3d& r) { result.segment<3>(first_of(i)) = r; });
  return result;
}

Eigen::MatrixXd residual_jacobian(const TensionSegment& segment, const Goal& goal, std::size_t index,
                                  std::span<const double> values) {
  const BlendingRows rows = rows_at(segment, values);
  return jacobian_of(segment, goal, index, values.size(), [&](std::size_t v) {
    return Shape<Jet<double, 1>>{along(rows, segment.slopes[v]), constant_increments<Jet<double, 1>>(segment),
                                 constant<Jet<double, 1>>(segment.from)};
  });
}

Eigen::MatrixXd residual_jacobian(const TensionSegment& segment, const Goal& goal, std::size_t index,
                                  std::span<const SegmentSlope> slopes) {
  const auto rows = constant_rows<Jet<double, 1>>(segment.constant);
  return jacobian_of(segment, goal, index, slopes.size(), [&](std::size_t v) {
    return Shape<Jet<double, 1>>{rows, along(segment.increments, slopes[v].increments),
                                 along(segment.from, slopes[v].from),
                                 along(segment.correction.value_or(Eigen::Vector3d::Zero()), slopes[v].correction)};
  });
}

}}  // namespace orispline
