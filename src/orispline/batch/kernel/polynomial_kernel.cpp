// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set, as kernel.cpp: ORISPLINE_POLYNOMIAL_KERNELS names what this one defines.
#include <orispline/batch/kernel/block.hpp>
#include <orispline/batch/kernel/polynomial_record.hpp>

namespace orispline::batch {
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

/// One component's derivative of order 1 or 2 in s, times `scale`.
template <int Order, int Degree, class T>
[[gnu::always_inline]] inline void derivatives(const T (&c)[Degree + 1], T scale, const Plane<T>& s, int padded,
                                               Plane<T>& to) {
  T d[Degree + 1 - Order];
#pragma GCC unroll 16
  for (int k = Order; k <= Degree; ++k) d[k - Order] = static_cast<T>(Order == 1 ? k : k * (k - 1)) * c[k];
  for (int i = 0; i < padded; ++i) {
    T sum = d[Degree - Order];
#pragma GCC unroll 16
    for (int k = Degree - Order - 1; k >= 0; --k) sum = sum * s[i] + d[k];
    to[i] = scale * sum;
  }
}

template <class T, int Components, int Degree>
struct PolynomialBlock {
  explicit PolynomialBlock(const PolynomialRecord<T, Components, Degree>& r) : record(r) {}

  const PolynomialRecord<T, Components, Degree> record;  // a copy that no output can alias
  alignas(64) Plane<T> s, p[Components];

  [[gnu::always_inline]] inline void write_values(int count, int padded, T* to, std::size_t at, std::ptrdiff_t planes) {
    for (int k = 0; k < Components; ++k) values<Degree>(record.coefficients[k], s, padded, p[k]);
    lay_out(p, count, to, at, planes);
  }
  template <int Order>
  [[gnu::always_inline]] inline void write_derivatives(int count, int padded, T* to, std::size_t at,
                                                       std::ptrdiff_t planes) {
    if (!to) return;
    const T per_step = static_cast<T>(record.per_step), scale = Order == 1 ? per_step : per_step * per_step;
    for (int k = 0; k < Components; ++k) derivatives<Order, Degree>(record.coefficients[k], scale, s, padded, p[k]);
    lay_out(p, count, to, at, planes);
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

template <class T>
void baked(const BakedRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) {
  by_blocks(record, clock, count, [&](auto& samples, int here, int padded, std::size_t at) {
    samples.write_values(here, padded, target.orientation, at, target.planes);
  });
}

template <class T>
void path(const PathRecord<T>& record, const Clock& clock, std::size_t count, const PathTarget<T>& target) {
  by_blocks(record, clock, count, [&](auto& samples, int here, int padded, std::size_t at) {
    if (target.position) samples.write_values(here, padded, target.position, at, target.planes);
    samples.template write_derivatives<1>(here, padded, target.velocity, at, target.planes);
    samples.template write_derivatives<2>(here, padded, target.acceleration, at, target.planes);
  });
}

}  // namespace

extern const PolynomialKernels ORISPLINE_POLYNOMIAL_KERNELS;
const PolynomialKernels ORISPLINE_POLYNOMIAL_KERNELS{&baked<double>, &baked<float>, &path<double>, &path<float>};

}  // namespace orispline::batch
