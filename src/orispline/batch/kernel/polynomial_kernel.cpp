// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as kernel.cpp: ORISPLINE_POLYNOMIAL_KERNELS names what this one defines.
#include <orispline/batch/kernel/block.hpp>
#include <orispline/batch/kernel/polynomial_record.hpp>
#include <orispline/batch/kernel/vector.hpp>

namespace orispline::inline ORISPLINE_ABI::batch {
namespace {

/// One component's values at the parameters s.
template <int Degree, class T>
[[gnu::always_inline]] inline void values(const T (&c)[Degree + 1], const Plane<T>& s, int padded, Plane<T>& to) {
  for (int i = 0; i < padded; ++i) {
    T sum = c[Degree];
#pragma GCC unroll 16
    for (int k = Degree - 1; k >= 0; --k) sum = sum * s[i] + c[k];
    to[i] = sum;
  }
}

/// k (k - 1) …: what is left of s^k by as many derivatives.
constexpr int falling(int k, int order) { return order == 0 ? 1 : k * falling(k - 1, order - 1); }

/// One component's derivative of order 1 to 3 in s, times `scale`.
template <int Order, int Degree, class T>
[[gnu::always_inline]] inline void derivatives(const T (&c)[Degree + 1], T scale, const Plane<T>& s, int padded,
                                               Plane<T>& to) {
  T d[Degree + 1 - Order];
#pragma GCC unroll 16
  for (int k = Order; k <= Degree; ++k) d[k - Order] = static_cast<T>(falling(k, Order)) * c[k];
  for (int i = 0; i < padded; ++i) {
    T sum = d[Degree - Order];
#pragma GCC unroll 16
    for (int k = Degree - Order - 1; k >= 0; --k) sum = sum * s[i] + d[k];
    to[i] = scale * sum;
  }
}

/// per_step to the power of the order.
template <int Order, class T>
[[gnu::always_inline]] inline T scale_of(T per_step) {
  if constexpr (Order == 1) return per_step;
  else return scale_of<Order - 1>(per_step) * per_step;
}

template <class T, int Components, int Degree>
struct PolynomialBlock {
  explicit PolynomialBlock(const PolynomialRecord<T, Components, Degree>& r) : record(r) {}

  const PolynomialRecord<T, Components, Degree> record;  // a copy that no output can alias
  alignas(64) Plane<T> s, p[Components];

  [[gnu::always_inline]] inline void write_values(int count, int padded, T* to, std::size_t at, std::ptrdiff_t planes) {
    evaluate(padded, p);
    lay_out(p, count, to, at, planes);
  }
  template <int Order>
  [[gnu::always_inline]] inline void write_derivatives(int count, int padded, T* to, std::size_t at,
                                                       std::ptrdiff_t planes) {
    if (!to) return;
    derive<Order>(padded, p);
    lay_out(p, count, to, at, planes);
  }
  [[gnu::always_inline]] inline void evaluate(int padded, Plane<T> (&to)[Components]) {
    for (int k = 0; k < Components; ++k) values<Degree>(record.coefficients[k], s, padded, to[k]);
  }
  template <int Order>
  [[gnu::always_inline]] inline void derive(int padded, Plane<T> (&to)[Components]) {
    const T scale = scale_of<Order>(static_cast<T>(record.per_step));
    for (int k = 0; k < Components; ++k) derivatives<Order, Degree>(record.coefficients[k], scale, s, padded, to[k]);
  }
};

/// Calls `write(samples, count, padded, at)` for every block of samples, their local parameters formed.
template <class T, int Components, int Degree, class Write>
[[gnu::always_inline]] inline void by_blocks(const PolynomialRecord<T, Components, Degree>& record, const Clock& clock,
                                             std::size_t count, Write write) {
  PolynomialBlock<T, Components, Degree> samples(record);
  in_blocks(
      count, [&](std::size_t at, int here, int padded) __attribute__((always_inline)) {
        local_times<T>(samples.record, clock, at, here, padded, samples.s);
        write(samples, here, padded, at);
      });
}

/// Derivatives of a quaternion of any norm, by order and component.
template <class T>
struct QuaternionPlanes {
  alignas(64) Plane<T> orders[3][4];

  [[gnu::always_inline]] Turn<T> operator()(int order, int i) const {
    const auto& q = orders[order - 1];
    return {q[3][i], q[0][i], q[1][i], q[2][i]};
  }
};

/// 2 vec(p̄ q).
template <class T>
[[gnu::always_inline]] inline Vector<T> twice_between(Turn<T> p, Turn<T> q) {
  const Turn<T> product = Turn<T>{p.w, -p.x, -p.y, -p.z} * q;
  return T(2) * Vector<T>{product.x, product.y, product.z};
}
template <class T>
[[gnu::always_inline]] inline T dot(Turn<T> p, Turn<T> q) {
  return (p.w * q.w + p.x * q.x) + (p.y * q.y + p.z * q.z);
}

/// The body rates of q/|q|: with w = 2 vec(q̄ q') and n = |q|², both differentiated as they stand, n ω = w.
template <Rates Wanted, class T>
[[gnu::always_inline]] inline BodyRates<T> quaternion_rates(Turn<T> q, const QuaternionPlanes<T>& derivatives, int i) {
  const Turn<T> q1 = derivatives(1, i);
  const T per_square = T(1) / dot(q, q);
  BodyRates<T> body{.omega = per_square * twice_between(q, q1), .alpha = {}, .jerk = {}};
  if constexpr (Wanted == Rates::none || Wanted == Rates::first) return body;
  const Turn<T> q2 = derivatives(2, i);
  const T growth = T(2) * dot(q, q1);
  body.alpha = per_square * (twice_between(q, q2) - growth * body.omega);
  if constexpr (Wanted == Rates::third) {
    const T growth_rate = T(2) * (dot(q1, q1) + dot(q, q2));
    body.jerk = per_square * ((twice_between(q, derivatives(3, i)) + twice_between(q1, q2)) -
                              ((T(2) * growth) * body.alpha + growth_rate * body.omega));
  }
  return body;
}

template <Rates Wanted, class T>
void baked_block(const BakedRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) {
  QuaternionPlanes<T> derivatives;
  OutputPlanes<T> out;
  by_blocks(
      record, clock, count, [&](auto& samples, int here, int padded, std::size_t at) __attribute__((always_inline)) {
        samples.evaluate(padded, out.q);
        samples.template derive<1>(padded, derivatives.orders[0]);
        if constexpr (Wanted >= Rates::second) samples.template derive<2>(padded, derivatives.orders[1]);
        if constexpr (Wanted >= Rates::third) samples.template derive<3>(padded, derivatives.orders[2]);
        for (int i = 0; i < padded; ++i)
          out.template store<Wanted>(
              i, quaternion_rates<Wanted>(Turn<T>{out.q[3][i], out.q[0][i], out.q[1][i], out.q[2][i]}, derivatives, i));
        lay_out<Wanted>(out, here, target, at);
      });
}

template <class T>
void baked(const BakedRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) {
  by_rates(target, [&]<Rates Wanted>() {
    if constexpr (Wanted != Rates::none) baked_block<Wanted>(record, clock, count, target);
    else
      by_blocks(record, clock, count, [&](auto& samples, int here, int padded, std::size_t at) {
        samples.write_values(here, padded, target.orientation, at, target.planes);
      });
  });
}

template <class T>
void path(const PathRecord<T>& record, const Clock& clock, std::size_t count, const PathTarget<T>& target) {
  by_blocks(record, clock, count, [&](auto& samples, int here, int padded, std::size_t at) {
    if (target.position) samples.write_values(here, padded, target.position, at, target.planes);
    samples.template write_derivatives<1>(here, padded, target.velocity, at, target.planes);
    samples.template write_derivatives<2>(here, padded, target.acceleration, at, target.planes);
    samples.template write_derivatives<3>(here, padded, target.jerk, at, target.planes);
  });
}

}  // namespace

extern const PolynomialKernels ORISPLINE_POLYNOMIAL_KERNELS;
const PolynomialKernels ORISPLINE_POLYNOMIAL_KERNELS{&baked<double>, &baked<float>, &path<double>, &path<float>};

}  // namespace orispline::inline ORISPLINE_ABI::batch
