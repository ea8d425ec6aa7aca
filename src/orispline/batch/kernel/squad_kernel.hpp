// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/kernel/block.hpp>
#include <orispline/batch/kernel/trigonometry.hpp>

// Orientations of a spherical quadrangle. In an anonymous namespace, so that every instruction set has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

template <class T>
struct Quaternion4 {
  T q[4];
};

template <class T>
[[gnu::always_inline]] inline Quaternion4<T> on_arc(const ArcRecord<T>& arc, T u) {
  const Circle<T> turn = Wide::at(arc.half_angle * u);
  Quaternion4<T> point;
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) point.q[k] = turn.cosine * arc.start[k] + turn.sine * arc.across[k];
  return point;
}

/// sin √z / √z, z ≤ 1
template <class T>
[[gnu::always_inline]] inline T sinc_of_square(T z) {
  return T(1) + z * polynomial(Series<T>::sin_wide, z);
}

/// slerp(a, b; 2u(1-u)) of the points a and b of the two arcs, x = φ the angle between them in R⁴: from |b - a|² =
/// 4 sin² ½φ without roots.
template <class T>
[[gnu::always_inline]] inline Quaternion4<T> squad_sample(const SquadRecord<T>& r, T u) {
  const Quaternion4<T> a = on_arc(r.outer, u), b = on_arc(r.inner, u);
  T square = T(0);
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) square += (b.q[k] - a.q[k]) * (b.q[k] - a.q[k]);
  const T y = T(0.25) * square, ratio = T(1) + y * polynomial(Series<T>::arcsine, y);
  const T x = square * ratio * ratio;  // φ²
  const T to_b = T(2) * u * (T(1) - u), to_a = T(1) - to_b, per_sinc = T(1) / sinc_of_square(x);
  const T of_a = to_a * sinc_of_square(to_a * to_a * x) * per_sinc;
  const T of_b = to_b * sinc_of_square(to_b * to_b * x) * per_sinc;
  Quaternion4<T> sample;
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) sample.q[k] = of_a * a.q[k] + of_b * b.q[k];
  return sample;
}

template <class T>
void squad(const SquadRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  if (count <= most_points) {
    for (std::size_t i = 0; i < count; ++i) put<T>(lanes_at(squad_sample(r, local_time<T>(r, clock, i)).q), i, target);
    return;
  }
  alignas(64) Plane<T> u, q[4];
  in_blocks(
      count, [&](std::size_t at, int here, int padded) __attribute__((always_inline)) {
        local_times<T>(r, clock, at, here, padded, u);
        for (int i = 0; i < padded; ++i) {
          const Quaternion4<T> sample = squad_sample(r, u[i]);
#pragma GCC unroll 4
          for (int k = 0; k < 4; ++k) q[k][i] = sample.q[k];
        }
        lay_out(q, here, target.orientation, at, target.planes);
      });
}

}  // namespace

}}}  // namespace orispline::batch
