// SPDX-License-Identifier: Apache-2.0
// Eberly, sections 3 to 6.
#include "papers/identities.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/math/geodesic.hpp>

#include "papers/papers_algebra.hpp"

namespace orispline::cli {

namespace {

using Unit = Eigen::Quaterniond;
using Order1 = Jet<double, 1>;

/// An orientation at a rotation of at most 1.7 rad from another.
Unit near_to(const Unit& q, Dice& dice) { return q * exp<double>(Eigen::Vector3d(dice.vector())); }

/// log(from⁻¹ to) as the note has it.
AnyQuaternion log_between(const Unit& from, const Unit& to) { return half_log(Unit(from.conjugate() * to)); }

/// The arguments of squad.
struct Quadrangle {
  explicit Quadrangle(Dice& dice)
      : p(dice.unit_quaternion()), a(near_to(p, dice)), b(near_to(p, dice)), q(near_to(p, dice)) {}
  Unit p, a, b, q;

  [[nodiscard]] Quaternion<Order1> squad_at(double t) const {
    return squad<Order1>(constant<Order1>(p), constant<Order1>(a), constant<Order1>(b), constant<Order1>(q),
                         Order1::variable(t));
  }
};

Quaternion<Order1> slerp_at(const Unit& from, const Unit& to, double t) {
  return slerp<Order1>(constant<Order1>(from), constant<Order1>(to), Order1::variable(t));
}

/// (15) and its derivative for a constant angle, at t.
struct Coefficients {
  Coefficients(const Unit& from, const Unit& to, double t) {
    const double angle = std::acos(std::clamp(from.dot(to), -1.0, 1.0)), sine = std::sin(angle);
    c0 = std::sin((1 - t) * angle) / sine;
    c1 = std::sin(t * angle) / sine;
    slope0 = -angle * std::cos((1 - t) * angle) / sine;
    slope1 = angle * std::cos(t * angle) / sine;
  }
  double c0 = 0, c1 = 0, slope0 = 0, slope1 = 0;
};

/// (15).
AnyQuaternion slerp_by_sines(const AnyQuaternion& from, const AnyQuaternion& to, double t) {
  const Coefficients c(from.coefficients(), to.coefficients(), t);
  return c.c0 * from + c.c1 * to;
}

double error_of_15_and_16(Dice& dice) {
  const Unit p = dice.unit_quaternion(), q = near_to(p, dice);
  const double t = dice.between(0, 1);
  return gap(slerp_by_sines(p, q, t), slerp<double>(p, q, t));
}

double error_of_17(Dice& dice) {
  const Unit p = dice.unit_quaternion(), q = near_to(p, dice);
  const AnyQuaternion l = log_between(p, q);
  const double t = dice.between(0, 1);
  return std::max({gap(derivative(slerp_at(p, q, t), 1), slerp<double>(p, q, t) * l),
                   gap(derivative(slerp_at(p, q, 0), 1), p * l), gap(derivative(slerp_at(p, q, 1), 1), q * l)});
}

double error_of_18_and_19(Dice& dice) {
  const Quadrangle k(dice);
  const double t = dice.between(0, 1);
  const Unit arc = slerp<double>(k.p, k.q, t), inner = slerp<double>(k.a, k.b, t);
  const AnyQuaternion by_sines =
      slerp_by_sines(slerp_by_sines(k.p, k.q, t), slerp_by_sines(k.a, k.b, t), 2 * t * (1 - t));
  return gap(by_sines, arc * pow<double>(Unit(arc.conjugate() * inner), 2 * t * (1 - t)));
}

double error_of_20(Dice& dice) {
  const Quadrangle k(dice);
  const AnyQuaternion l = log_between(k.p, k.q);
  return std::max(gap(derivative(k.squad_at(0), 1), k.p * (l + 2.0 * log_between(k.p, k.a))),
                  gap(derivative(k.squad_at(1), 1), k.q * (l - 2.0 * log_between(k.q, k.b))));
}

/// Five neighbouring keys; the inner quaternions by (22).
struct Spline {
  explicit Spline(Dice& dice) {
    q[0] = dice.unit_quaternion();
    for (std::size_t n = 1; n < 5; ++n) q[n] = near_to(q[n - 1], dice);
  }
  [[nodiscard]] Unit inner(std::size_t n) const {
    const AnyQuaternion sum = log_between(q[n], q[n + 1]) + log_between(q[n], q[n - 1]);
    return q[n] * half_exp(-0.25 * sum.vector()).coefficients();
  }
  /// S_n with the given inner quaternions.
  [[nodiscard]] Quaternion<Order1> segment(std::size_t n, const Unit& a, const Unit& b, double t) const {
    return squad<Order1>(constant<Order1>(q[n]), constant<Order1>(a), constant<Order1>(b), constant<Order1>(q[n + 1]),
                         Order1::variable(t));
  }
  std::array<Unit, 5> q;
};

double error_of_21_and_22(Dice& dice) {
  const Spline s(dice);
  const Unit a1 = s.inner(1), a2 = s.inner(2), a3 = s.inner(3);
  const AnyQuaternion tangent = 0.5 * (log_between(s.q[2], s.q[3]) + log_between(s.q[1], s.q[2]));
  const auto before = s.segment(1, a1, a2, 1), after = s.segment(2, a2, a3, 0);
  return std::max({gap(derivative(before, 0), s.q[2]), gap(derivative(after, 0), s.q[2]),
                   gap(derivative(before, 1), s.q[2] * tangent), gap(derivative(after, 1), s.q[2] * tangent)});
}

double error_of_13_and_14(Dice& dice) {
  const Unit q = dice.unit_quaternion();
  const double t = dice.between(0, 1);
  const auto s = Order1::variable(t);
  const Order1 f = s * s * (s - Order1(0.5));
  const auto power = pow<Order1>(constant<Order1>(q), s), of_f = pow<Order1>(constant<Order1>(q), f);
  const AnyQuaternion l = half_log(q);
  return std::max(gap(derivative(power, 1), derivative(power, 0) * l),
                  gap(derivative(of_f, 1), f.derivative(1) * (derivative(of_f, 0) * l)));
}

/// Section 5, S'(t) at t = 0.3, with the angle between the points of the two arcs taken for a constant.
double error_of_inner_derivative(Dice& dice) {
  const Quadrangle k(dice);
  const double t = 0.3;
  const auto u = slerp_at(k.p, k.q, t), v = slerp_at(k.a, k.b, t);
  const AnyQuaternion u0 = derivative(u, 0), u1 = derivative(u, 1), v0 = derivative(v, 0), v1 = derivative(v, 1);
  const Coefficients c(u0.coefficients(), v0.coefficients(), 2 * t * (1 - t));
  const double inner = 2 - 4 * t;
  const AnyQuaternion printed = c.c0 * u1 + c.slope0 * inner * u0 + c.c1 * v1 + c.slope1 * inner * v0;
  return gap(printed, derivative(k.squad_at(t), 1));
}

/// Section 6, S'_{n-1}(1) in terms of the inner quaternion, with one or the other logarithm.
double error_of_arriving(Dice& dice, AnyQuaternion (*logarithm)(const Spline&)) {
  const Spline s(dice);
  const Unit a = near_to(s.q[1], dice), b = near_to(s.q[2], dice);
  const AnyQuaternion rate = logarithm(s) - 2.0 * log_between(s.q[2], b);
  return gap(derivative(s.segment(1, a, b, 1), 1), s.q[2] * rate);
}

/// Section 6, the planar example: θ_{n-1} … θ_{n+2} and t.
struct Planar {
  explicit Planar(Dice& dice) : t(dice.between(0, 1)) {
    for (double& angle : theta) angle = dice.between(-0.5, 0.5);
  }
  std::array<double, 4> theta{};
  double t;

  /// `share` stands before the first difference: 1 - t is right, 1 is printed.
  [[nodiscard]] double angle(double share) const {
    const auto& [before, start, end, after] = theta;
    return (1 - 2 * t * (1 - t)) * ((1 - t) * start + t * end) -
           0.5 * t * (1 - t) * (share * (end - 6 * start + before) + t * (after - 6 * end + start));
  }
  /// By quaternions about x.
  [[nodiscard]] double angle_of_squad() const {
    const auto turn = [](double angle) { return Unit(std::cos(angle), std::sin(angle), 0, 0); };
    const auto inner = [&](std::size_t n) { return turn(-(theta[n + 1] - 6 * theta[n] + theta[n - 1]) / 4); };
    const Unit q = squad<double>(turn(theta[1]), inner(1), inner(2), turn(theta[2]), t);
    return std::atan2(q.x(), q.w());
  }
};

constexpr std::array identities{
    Identity{"(13), (14)", "(q^t)' = q^t log q, (q^f(t))' = f'(t) q^f(t) log q", error_of_13_and_14},
    Identity{"(15), (16)", "slerp by sines = p (p⁻¹ q)^t", error_of_15_and_16},
    Identity{"(17)", "slerp'(t) = slerp(t) log(p⁻¹ q), and at both ends", error_of_17},
    Identity{"(18), (19)", "squad by sines = slerp (slerp⁻¹ slerp)^(2t(1−t))", error_of_18_and_19},
    Identity{"(20)", "squad'(0), squad'(1)", error_of_20},
    Identity{"(21), (22)", "S(n−1)(1) = q_n = S(n)(0), S(n−1)'(1) = q_n T_n = S(n)'(0)", error_of_21_and_22}};

constexpr std::array misprints{
    Misprint{"section 5", "S'(t) with a constant inner angle, at t = 0.3", error_of_inner_derivative,
             "so at t = 0 and 1 only: (20)", error_of_20},
    Misprint{
        "section 6", "S(n−1)'(1) with log(q_n⁻¹ q_n)",
        [](Dice& dice) { return error_of_arriving(dice, [](const Spline& s) { return log_between(s.q[2], s.q[2]); }); },
        "log(q_(n−1)⁻¹ q_n)",
        [](Dice& dice) {
          return error_of_arriving(dice, [](const Spline& s) { return log_between(s.q[1], s.q[2]); });
        }},
    Misprint{"section 6", "angle of the planar squad without (1−t)",
             [](Dice& dice) {
               const Planar planar(dice);
               return std::abs(planar.angle(1.0) - planar.angle_of_squad());
             },
             "(1−t) before the first difference",
             [](Dice& dice) {
               const Planar planar(dice);
               return std::abs(planar.angle(1.0 - planar.t) - planar.angle_of_squad());
             }}};

}  // namespace

std::span<const Identity> interpolation_identities() noexcept { return identities; }
std::span<const Misprint> interpolation_misprints() noexcept { return misprints; }

}  // namespace orispline::cli
