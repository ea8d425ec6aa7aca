// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as kernel.cpp: ORISPLINE_POLYNOMIAL_KERNELS names what this one defines.
#include <orispline/batch/kernel/block.hpp>
#include <orispline/batch/kernel/record.hpp>
#include <orispline/batch/kernel/vector.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

namespace {

[[gnu::always_inline]] inline double square_root(double x) { return __builtin_sqrt(x); }
[[gnu::always_inline]] inline float square_root(float x) { return __builtin_sqrtf(x); }

/// A polynomial with rising powers.
template <class T, int N>
[[gnu::always_inline]] inline T horner(const T (&c)[N], T s) {
  T sum = c[N - 1];
#pragma GCC unroll 16
  for (int k = N - 2; k >= 0; --k) sum = sum * s + c[k];
  return sum;
}

/// One component's values at the parameters s.
template <int Degree, class T>
[[gnu::always_inline]] inline void values(const T (&c)[Degree + 1], const Plane<T>& s, int padded, Plane<T>& to) {
  for (int i = 0; i < padded; ++i) to[i] = horner(c, s[i]);
}

/// k (k - 1) …: what is left of s^k by as many derivatives.
constexpr int falling(int k, int order) { return order == 0 ? 1 : k * falling(k - 1, order - 1); }

/// The derivative of order 1 to 3 of one component in s.
template <int Order, int Degree, class T>
struct Derived {
  T coefficients[Degree + 1 - Order];

  [[gnu::always_inline]] explicit Derived(const T (&c)[Degree + 1]) {
#pragma GCC unroll 16
    for (int k = Order; k <= Degree; ++k) coefficients[k - Order] = static_cast<T>(falling(k, Order)) * c[k];
  }
};

/// One component's derivative at the parameters s, times `scale`.
template <int Order, int Degree, class T>
[[gnu::always_inline]] inline void derivatives(const T (&c)[Degree + 1], T scale, const Plane<T>& s, int padded,
                                               Plane<T>& to) {
  const Derived<Order, Degree, T> d(c);
  for (int i = 0; i < padded; ++i) to[i] = scale * horner(d.coefficients, s[i]);
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
/// `derivative(order)` are those of a quaternion of any norm.
template <Rates Wanted, class T, class Derivative>
[[gnu::always_inline]] inline BodyRates<T> quaternion_rates(Turn<T> q, Derivative derivative) {
  const Turn<T> q1 = derivative(1);
  const T per_square = T(1) / dot(q, q);
  BodyRates<T> body{.omega = per_square * twice_between(q, q1), .alpha = {}, .jerk = {}};
  if constexpr (Wanted == Rates::none || Wanted == Rates::first) return body;
  const Turn<T> q2 = derivative(2);
  const T growth = T(2) * dot(q, q1);
  body.alpha = per_square * (twice_between(q, q2) - growth * body.omega);
  if constexpr (Wanted == Rates::third) {
    const T growth_rate = T(2) * (dot(q1, q1) + dot(q, q2));
    body.jerk = per_square * ((twice_between(q, derivative(3)) + twice_between(q1, q2)) -
                              ((T(2) * growth) * body.alpha + growth_rate * body.omega));
  }
  return body;
}

/// What the quaternions of a sample are divided by.
template <class T>
[[gnu::always_inline]] inline T per_norm(Turn<T> q) {
  return T(1) / square_root(dot(q, q));
}

/// What becomes of the quaternion that a polynomial gives.
enum class Norm { left, made_one };

template <class T>
[[gnu::always_inline]] inline Turn<T> turn_at(const Plane<T> (&q)[4], int i) {
  return {q[3][i], q[0][i], q[1][i], q[2][i]};
}

/// Orientations with rates.
template <Rates Wanted, Norm Asked, class T, int Degree>
void quaternion_block(const PolynomialRecord<T, 4, Degree>& record, const Clock& clock, std::size_t count,
                      const Target<T>& target) {
  alignas(64) Plane<T> orders[3][4];
  OutputPlanes<T> out;
  by_blocks(
      record, clock, count, [&](auto& samples, int here, int padded, std::size_t at) __attribute__((always_inline)) {
        samples.evaluate(padded, out.q);
        samples.template derive<1>(padded, orders[0]);
        if constexpr (Wanted >= Rates::second) samples.template derive<2>(padded, orders[1]);
        if constexpr (Wanted >= Rates::third) samples.template derive<3>(padded, orders[2]);
        for (int i = 0; i < padded; ++i)
          out.template store<Wanted>(i, quaternion_rates<Wanted>(
                                            turn_at(out.q, i), [&](int order) __attribute__((always_inline)) {
                                              return turn_at(orders[order - 1], i);
                                            }));
        if constexpr (Asked == Norm::made_one)
          for (int i = 0; i < padded; ++i) {
            const T scale = per_norm(turn_at(out.q, i));
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k) out.q[k][i] *= scale;
          }
        lay_out<Wanted>(out, here, target, at);
      });
}

template <class T>
void baked(const BakedRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) {
  by_rates(target, [&]<Rates Wanted>() {
    if constexpr (Wanted != Rates::none) quaternion_block<Wanted, Norm::left>(record, clock, count, target);
    else
      by_blocks(record, clock, count, [&](auto& samples, int here, int padded, std::size_t at) {
        samples.write_values(here, padded, target.orientation, at, target.planes);
      });
  });
}

/// Orientations alone, in parts of a block that stay in registers: there is so little to compute that planes in memory
/// would take as long.
template <class T>
void rational_block(const RationalRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) {
  constexpr int part = 16;
  const RationalRecord<T> r = record;  // a copy that no output can alias
  alignas(64) Plane<T> s;
  alignas(64) T q[4][part];
  in_blocks(
      count, [&](std::size_t at, int here, int) __attribute__((always_inline)) {
        local_times<T>(r, clock, at, here, (here + part - 1) / part * part, s);
        for (int from = 0; from < here; from += part) {
#pragma GCC unroll 1  // as in lay_out()
          for (int i = 0; i < part; ++i) {
            T c[4];
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k) c[k] = horner(r.coefficients[k], s[from + i]);
            const T scale = per_norm(Turn<T>{c[3], c[0], c[1], c[2]});
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k) q[k][i] = c[k] * scale;
          }
          lay_out(q, here - from < part ? here - from : part, target.orientation, at + static_cast<std::size_t>(from),
                  target.planes);
        }
      });
}

template <Rates Wanted, class T>
[[gnu::always_inline]] inline void rational_point(const RationalRecord<T>& r, T s, const Target<T>& target,
                                                  std::size_t at) {
  const auto& c = r.coefficients;
  const Turn<T> q{horner(c[3], s), horner(c[0], s), horner(c[1], s), horner(c[2], s)};
  const T scale = per_norm(q);
  put<T>(Lanes<T>{q.x * scale, q.y * scale, q.z * scale, q.w * scale}, at, target);
  if constexpr (Wanted != Rates::none) {
    const auto component = [&]<int Order>(int k) __attribute__((always_inline)) {
      return scale_of<Order>(static_cast<T>(r.per_step)) * horner(Derived<Order, 3, T>(c[k]).coefficients, s);
    };
    const auto derivative = [&]<int Order>() __attribute__((always_inline)) {
      return Turn<T>{component.template operator()<Order>(3), component.template operator()<Order>(0),
                     component.template operator()<Order>(1), component.template operator()<Order>(2)};
    };
    const Turn<T> orders[3]{derivative.template operator()<1>(), derivative.template operator()<2>(),
                            derivative.template operator()<3>()};
    put(quaternion_rates<Wanted>(
            q, [&](int order) __attribute__((always_inline)) { return orders[order - 1]; }),
        at, target);
  }
}

template <class T>
void rational(const RationalRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) {
  if (count <= most_points) {
    for (std::size_t i = 0; i < count; ++i) {
      const T s = local_time<T>(record, clock, i);
      by_rates_of_points(target, [&]<Rates Wanted>() { rational_point<Wanted>(record, s, target, i); });
    }
    return;
  }
  by_rates(target, [&]<Rates Wanted>() {
    if constexpr (Wanted != Rates::none) quaternion_block<Wanted, Norm::made_one>(record, clock, count, target);
    else rational_block(record, clock, count, target);
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
const PolynomialKernels ORISPLINE_POLYNOMIAL_KERNELS{&baked<double>,   &baked<float>, &rational<double>,
                                                     &rational<float>, &path<double>, &path<float>};

}}}  // namespace orispline::batch
