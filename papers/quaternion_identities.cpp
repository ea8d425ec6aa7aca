// SPDX-License-Identifier: Apache-2.0
// Eberly, sections 1 and 2, and the tables of all identities.
#include "papers/experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/math/geodesic.hpp>

#include "papers/identities.hpp"
#include "papers/papers_algebra.hpp"

namespace orispline::cli {

namespace {

using Vector = Eigen::Vector3d;

AnyQuaternion any(Dice& dice) { return {dice.between(-1, 1), dice.vector()}; }
AnyQuaternion pure(const Vector& v) { return {0.0, v}; }
AnyQuaternion real(double w) { return {w, Vector::Zero()}; }
AnyQuaternion rotated(const AnyQuaternion& q, const AnyQuaternion& v) { return q * v * q.conjugate(); }

/// cos θ + û sin θ with its parts.
struct UnitQuaternion {
  explicit UnitQuaternion(Dice& dice) : angle(dice.between(0.0, 3.1)), axis(dice.unit_vector()) {}
  double angle;
  Vector axis;
  [[nodiscard]] AnyQuaternion value() const { return {std::cos(angle), std::sin(angle) * axis}; }
};

/// An orthonormal right-handed set that begins with u.
struct Axes {
  explicit Axes(const Vector& first) : u(first), v(first.unitOrthogonal()), w(u.cross(v)) {}
  Vector u, v, w;
};

/// exp as its power series.
AnyQuaternion series_exp(const AnyQuaternion& p) {
  AnyQuaternion term = real(1.0), sum = term;
  for (int k = 1; k < 40; ++k) sum = sum + (term = 1.0 / k * (term * p));
  return sum;
}

double determinant(const AnyQuaternion& q) {
  Eigen::Matrix3d m;
  for (int axis = 0; axis < 3; ++axis) m.col(axis) = rotated(q, pure(Vector::Unit(axis))).vector();
  return m.determinant();
}

constexpr std::array algebra{
    Identity{"(2)", "product by its components, with the + that is missing",
             [](Dice& dice) {
               const AnyQuaternion p = any(dice), q = any(dice);
               const double a = p.scalar(), w = q.scalar();
               const Vector b = p.vector(), v = q.vector();
               const Vector sum(a * v.x() + b.x() * w + b.y() * v.z() - b.z() * v.y(),
                                a * v.y() - b.x() * v.z() + b.y() * w + b.z() * v.x(),
                                a * v.z() + b.x() * v.y() - b.y() * v.x() + b.z() * w);
               return gap(p * q, {a * w - b.x() * v.x() - b.y() * v.y() - b.z() * v.z(), sum});
             }},
    Identity{"(3)", "(p*)* = p and (pq)* = q* p*",
             [](Dice& dice) {
               const AnyQuaternion p = any(dice), q = any(dice);
               return std::max(gap(p.conjugate().conjugate(), p),
                               gap((p * q).conjugate(), q.conjugate() * p.conjugate()));
             }},
    Identity{"(4)", "N(q*) = N(q) and N(pq) = N(p) N(q)",
             [](Dice& dice) {
               const AnyQuaternion p = any(dice), q = any(dice);
               return std::max(std::abs(q.conjugate().norm() - q.norm()),
                               std::abs((p * q).norm() - p.norm() * q.norm()));
             }},
    Identity{"(5)", "q⁻¹ q = q q⁻¹ = 1, (pq)⁻¹ = q⁻¹ p⁻¹, relative to their sizes",
             [](Dice& dice) {
               const AnyQuaternion p = any(dice), q = any(dice);
               const double one = std::max(gap(q * q.inverse(), real(1.0)), gap(q.inverse() * q, real(1.0)));
               return std::max(one, (p * q).norm() * gap((p * q).inverse(), q.inverse() * p.inverse()));
             }},
    Identity{"(6)", "W(q) = (q + q*)/2",
             [](Dice& dice) {
               const AnyQuaternion q = any(dice);
               return gap(real(q.scalar()), 0.5 * (q + q.conjugate()));
             }},
    Identity{"(7)", "product by dot and cross product",
             [](Dice& dice) {
               const AnyQuaternion p = any(dice), q = any(dice);
               const Vector a = p.vector(), b = q.vector();
               return gap(p * q, {p.scalar() * q.scalar() - a.dot(b), p.scalar() * b + q.scalar() * a + a.cross(b)});
             }},
    Identity{"(8)", "p · q = W(p q*)",
             [](Dice& dice) {
               const AnyQuaternion p = any(dice), q = any(dice);
               return std::abs(p.scalar() * q.scalar() + p.vector().dot(q.vector()) - (p * q.conjugate()).scalar());
             }},
    Identity{"(9)", "û û = −1, N(cos θ + û sin θ) = 1",
             [](Dice& dice) {
               const UnitQuaternion q(dice);
               return std::max(gap(pure(q.axis) * pure(q.axis), real(-1.0)), std::abs(q.value().norm() - 1.0));
             }},
    Identity{"(10)", "exp(û θ) = cos θ + û sin θ, exp by its power series",
             [](Dice& dice) {
               const UnitQuaternion q(dice);
               return std::max(gap(series_exp(pure(q.angle * q.axis)), q.value()),
                               gap(half_exp(q.angle * q.axis), q.value()));
             }},
    Identity{"(11)", "q^t = cos tθ + û sin tθ",
             [](Dice& dice) {
               const UnitQuaternion q(dice);
               const double t = dice.between(0, 1);
               const AnyQuaternion wanted{std::cos(t * q.angle), std::sin(t * q.angle) * q.axis};
               return gap(pow<double>(q.value().coefficients(), t), wanted);
             }},
    Identity{"(12)", "log(exp(û θ)) = û θ, θ in [0, π)", [](Dice& dice) {
               const UnitQuaternion q(dice);
               return gap(half_log(half_exp(q.angle * q.axis)), pure(q.angle * q.axis));
             }}};

constexpr std::array rotations{
    Identity{"2", "W(q v̂ q*) = 0 and N(q v̂ q*) = N(v̂)",
             [](Dice& dice) {
               const AnyQuaternion q = dice.unit_quaternion(), v = pure(dice.vector());
               return std::max(std::abs(rotated(q, v).scalar()), std::abs(rotated(q, v).norm() - v.norm()));
             }},
    Identity{"2", "R(a v̂ + ŵ) = a R(v̂) + R(ŵ)",
             [](Dice& dice) {
               const AnyQuaternion q = dice.unit_quaternion(), v = pure(dice.vector()), w = pure(dice.vector());
               const double a = dice.between(-1, 1);
               return gap(rotated(q, a * v + w), a * rotated(q, v) + rotated(q, w));
             }},
    Identity{"2", "det R = 1: no reflection",
             [](Dice& dice) { return std::abs(determinant(dice.unit_quaternion()) - 1.0); }},
    Identity{"2", "R(û) = û: the axis",
             [](Dice& dice) {
               const UnitQuaternion q(dice);
               return gap(rotated(q.value(), pure(q.axis)), pure(q.axis));
             }},
    Identity{"2", "v · R(v) = cos 2θ and, not in the note, w · R(v) = sin 2θ", [](Dice& dice) {
               const UnitQuaternion q(dice);
               const Axes axes(q.axis);
               const Vector turned = rotated(q.value(), pure(axes.v)).vector();
               return std::max(std::abs(axes.v.dot(turned) - std::cos(2 * q.angle)),
                               std::abs(axes.w.dot(turned) - std::sin(2 * q.angle)));
             }}};

}  // namespace

Expected<Findings> experiment::quaternion_identities() {
  const std::array<std::span<const Identity>, 3> parts{algebra, rotations, interpolation_identities()};
  return Findings{
      {identities_table(formatted("Eberly's identities on {} random draws each", draws_of_identities), parts,
                        {"Errors are lengths of differences, in double precision; the draws are the same "
                         "on every machine.",
                         "N is the squared length here, as in the note; p, q of (2) to (8) are quaternions "
                         "of any length."}),
       misprints_table(interpolation_misprints())}};
}

}  // namespace orispline::cli
