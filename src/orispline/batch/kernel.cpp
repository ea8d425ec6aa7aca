// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: ORISPLINE_KERNELS names what this one defines. Everything else stands in an
// anonymous namespace, so that the linker cannot mix them. Without contraction into fused multiply-adds all of them
// give the same bits.
#include <orispline/batch/block.hpp>
#include <orispline/batch/trigonometry.hpp>
#include <orispline/batch/vector.hpp>

namespace orispline::batch {
namespace {

enum class Rates { none, first, second };

template <class T>
struct Planes {
  alignas(64) Plane<T> s, q[4], omega[3], alpha[3];
};

/// A polynomial with its first two derivatives.
template <class T>
struct Taylor {
  T value, first, second;
};

template <int Degree, class T>
[[gnu::always_inline]] inline T value_of(const T* c, T s) {
  T sum = c[Degree];
#pragma GCC unroll 16
  for (int k = Degree - 1; k >= 0; --k) sum = sum * s + c[k];
  return sum;
}

template <int Degree, class T>
[[gnu::always_inline]] inline Taylor<T> taylor_of(const T* c, T s) {
  Taylor<T> p{c[Degree], T(0), T(0)};
#pragma GCC unroll 16
  for (int k = Degree - 1; k >= 0; --k) {
    p.second = p.second * s + p.first;
    p.first = p.first * s + p.value;
    p.value = p.value * s + c[k];
  }
  p.second = p.second + p.second;
  return p;
}

template <class T>
[[gnu::always_inline]] inline void product(const CumulativeRecord<T>& r, Circle<T> a, Circle<T> b, Circle<T> c,
                                           Planes<T>& p, int i) {
  const T w0 = a.cosine * b.cosine, w1 = a.sine * b.cosine, w2 = a.cosine * b.sine, w3 = a.sine * b.sine;
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    const T straight =
        w3 * r.products[3][k] + (w2 * r.products[2][k] + (w1 * r.products[1][k] + w0 * r.products[0][k]));
    const T turned = w3 * r.products[7][k] + (w2 * r.products[6][k] + (w1 * r.products[5][k] + w0 * r.products[4][k]));
    p.q[k][i] = c.sine * turned + c.cosine * straight;
  }
}

template <class T>
[[gnu::always_inline]] inline void store(Plane<T> (&to)[3], int i, Vector<T> v) {
  to[0][i] = v.x;
  to[1][i] = v.y;
  to[2][i] = v.z;
}

/// The half rates of exp(a x_a) exp(b x_b) exp(c x_c), first in the frame after b, then turned by the last factor.
template <class T>
[[gnu::always_inline]] inline void rates(const CumulativeRecord<T>& r, const Taylor<T>& a, const Taylor<T>& b,
                                         const Taylor<T>& c, Circle<T> cb, Circle<T> cc, T per_step, bool second,
                                         Planes<T>& p, int i) {
  const Vector<T> axis_b = vector(r.axis_b), axis_c = vector(r.axis_c);
  const Vector<T> p1 = vector(r.carried[1]), p2 = vector(r.carried[2]);
  const T cos_b = T(1) - T(2) * cb.sine * cb.sine, sin_b = T(2) * cb.sine * cb.cosine;
  const T versine_c = T(2) * cc.sine * cc.sine, cos_c = T(1) - versine_c, sin_c = T(2) * cc.sine * cc.cosine;
  const Vector<T> axis_a = vector(r.carried[0]) + (cos_b * p1 + sin_b * p2);
  const auto turned = [&](Vector<T> v) {
    return cos_c * v + (sin_c * cross(v, axis_c) + (versine_c * dot(axis_c, v)) * axis_c);
  };
  const Vector<T> before = turned(a.first * axis_a + b.first * axis_b);
  store(p.omega, i, (T(2) * per_step) * (before + c.first * axis_c));
  if (!second) return;
  const Vector<T> axis_a_rate = (T(2) * b.first) * (cos_b * p2 - sin_b * p1);
  const Vector<T> rate = (a.second * axis_a + a.first * axis_a_rate) + b.second * axis_b;
  const Vector<T> alpha = turned(rate) + ((T(2) * c.first) * cross(before, axis_c) + c.second * axis_c);
  store(p.alpha, i, (T(2) * per_step * per_step) * alpha);
}

template <int Degree, class Outer, class Inner, Rates Wanted, class T>
void cumulative_samples(const CumulativeRecord<T>& record, const Clock& clock, std::size_t count,
                        const Target<T>& target) {
  const CumulativeRecord<T> r = record;  // a copy that no output can alias
  const T per_step = static_cast<T>(r.per_step);
  Planes<T> p;
  for (std::size_t at = 0; at < count; at += block) {
    const int here = count - at < block ? static_cast<int>(count - at) : block;
    const int padded = (here + lanes - 1) / lanes * lanes;
    local_times<T>(r, clock, at, here, padded, p.s);
    for (int i = 0; i < padded; ++i) {
      const T s = p.s[i];
      if constexpr (Wanted == Rates::none) {
        product(r, Outer::at(value_of<Degree>(r.angles[0], s)), Inner::at(value_of<Degree>(r.angles[1], s)),
                Outer::at(value_of<Degree>(r.angles[2], s)), p, i);
      } else {
        const Taylor<T> a = taylor_of<Degree>(r.angles[0], s), b = taylor_of<Degree>(r.angles[1], s),
                        c = taylor_of<Degree>(r.angles[2], s);
        const Circle<T> cb = Inner::at(b.value), cc = Outer::at(c.value);
        product(r, Outer::at(a.value), cb, cc, p, i);
        rates(r, a, b, c, cb, cc, per_step, Wanted == Rates::second, p, i);
      }
    }
    lay_out(p.q, here, target.orientation, at, target.planes);
    if constexpr (Wanted != Rates::none) {
      if (target.angular_velocity) lay_out(p.omega, here, target.angular_velocity, at, target.planes);
      if constexpr (Wanted == Rates::second) lay_out(p.alpha, here, target.angular_acceleration, at, target.planes);
    }
  }
}

template <int Degree, class T>
void cumulative_of_degree(const CumulativeRecord<T>& r, const Clock& clock, std::size_t count,
                          const Target<T>& target) {
  const bool any = r.range == AngleRange::any;
  if (target.angular_acceleration)
    any ? cumulative_samples<Degree, Any, Any, Rates::second>(r, clock, count, target)
        : cumulative_samples<Degree, Wide, Wide, Rates::second>(r, clock, count, target);
  else if (target.angular_velocity)
    any ? cumulative_samples<Degree, Any, Any, Rates::first>(r, clock, count, target)
        : cumulative_samples<Degree, Wide, Wide, Rates::first>(r, clock, count, target);
  else if (any) cumulative_samples<Degree, Any, Any, Rates::none>(r, clock, count, target);
  else if (r.range == AngleRange::wide) cumulative_samples<Degree, Wide, Wide, Rates::none>(r, clock, count, target);
  else cumulative_samples<Degree, Narrow, Wide, Rates::none>(r, clock, count, target);
}

template <class T>
void cumulative(const CumulativeRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  r.short_degree ? cumulative_of_degree<5>(r, clock, count, target) : cumulative_of_degree<7>(r, clock, count, target);
}

/// ω = J_r(φ) φ̇ and its derivative, both in the local parameter.
template <class T>
[[gnu::always_inline]] inline void chart_rates(const Taylor<T> (&phi)[3], T x, T per_step, bool second, Planes<T>& p,
                                               int i) {
  using S = Series<T>;
  const Vector<T> v{phi[0].value, phi[1].value, phi[2].value}, d{phi[0].first, phi[1].first, phi[2].first};
  const T versine = polynomial(S::versine, x), defect = polynomial(S::sine_defect, x);
  const Vector<T> turn = cross(v, d), tilt = cross(v, turn);
  store(p.omega, i, per_step * (d + (defect * tilt - versine * turn)));
  if (!second) return;
  const Vector<T> d2{phi[0].second, phi[1].second, phi[2].second};
  const T growth = T(2) * dot(v, d);
  const T versine_rate = growth * polynomial(S::versine_slope, x),
          defect_rate = growth * polynomial(S::sine_defect_slope, x);
  const Vector<T> turn_rate = cross(v, d2), tilt_rate = cross(d, turn) + cross(v, turn_rate);
  const Vector<T> slope = (defect_rate * tilt - versine_rate * turn) + (defect * tilt_rate - versine * turn_rate);
  store(p.alpha, i, (per_step * per_step) * (d2 + slope));
}

template <int Degree, Rates Wanted, class T>
void chart_samples(const ChartRecord<T>& record, const Clock& clock, std::size_t count, const Target<T>& target) {
  const ChartRecord<T> r = record;
  const T per_step = static_cast<T>(r.per_step);
  Planes<T> p;
  for (std::size_t at = 0; at < count; at += block) {
    const int here = count - at < block ? static_cast<int>(count - at) : block;
    const int padded = (here + lanes - 1) / lanes * lanes;
    local_times<T>(r, clock, at, here, padded, p.s);
    for (int i = 0; i < padded; ++i) {
      const T s = p.s[i];
      Taylor<T> phi[3];
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k)
        phi[k] = Wanted == Rates::none ? Taylor<T>{value_of<Degree>(r.rotation_vector[k], s), T(0), T(0)}
                                       : taylor_of<Degree>(r.rotation_vector[k], s);
      const T x = phi[0].value * phi[0].value + phi[1].value * phi[1].value + phi[2].value * phi[2].value;
      const T u = T(0.25) * x;
      const T w = T(1) + u * polynomial(Series<T>::cos_wide, u);
      const T half_sinc = T(0.5) + T(0.5) * u * polynomial(Series<T>::sin_wide, u);
      const T vx = half_sinc * phi[0].value, vy = half_sinc * phi[1].value, vz = half_sinc * phi[2].value;
      p.q[0][i] = (r.base[3] * vx + r.base[0] * w) + (r.base[1] * vz - r.base[2] * vy);
      p.q[1][i] = (r.base[3] * vy + r.base[1] * w) + (r.base[2] * vx - r.base[0] * vz);
      p.q[2][i] = (r.base[3] * vz + r.base[2] * w) + (r.base[0] * vy - r.base[1] * vx);
      p.q[3][i] = (r.base[3] * w - r.base[0] * vx) - (r.base[1] * vy + r.base[2] * vz);
      if constexpr (Wanted != Rates::none) chart_rates(phi, x, per_step, Wanted == Rates::second, p, i);
    }
    lay_out(p.q, here, target.orientation, at, target.planes);
    if constexpr (Wanted != Rates::none) {
      if (target.angular_velocity) lay_out(p.omega, here, target.angular_velocity, at, target.planes);
      if constexpr (Wanted == Rates::second) lay_out(p.alpha, here, target.angular_acceleration, at, target.planes);
    }
  }
}

template <int Degree, class T>
void chart_of_degree(const ChartRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  if (target.angular_acceleration) chart_samples<Degree, Rates::second>(r, clock, count, target);
  else if (target.angular_velocity) chart_samples<Degree, Rates::first>(r, clock, count, target);
  else chart_samples<Degree, Rates::none>(r, clock, count, target);
}

template <class T>
void chart(const ChartRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  r.short_degree ? chart_of_degree<5>(r, clock, count, target) : chart_of_degree<7>(r, clock, count, target);
}

template <class T>
void bundle(const BundleSegment<T>& segment, std::size_t count, const Target<T>& target) {
  const std::size_t plane = segment.plane;
  const T a = segment.factors[0], b = segment.factors[1], c = segment.factors[2];
  alignas(64) Plane<T> q[4];
  for (std::size_t at = 0; at < count; at += block) {
    const int here = count - at < block ? static_cast<int>(count - at) : block;
    const int padded = (here + lanes - 1) / lanes * lanes;
    const T* from = segment.planes + at;
    for (int i = 0; i < padded; ++i) {
      const T* m = from + i;
      const Turn<T> product = ((Turn<T>{m[3 * plane], m[0], m[plane], m[2 * plane]} * turn(m + 4 * plane, plane, a)) *
                               turn(m + 7 * plane, plane, b)) *
                              turn(m + 10 * plane, plane, c);
      q[0][i] = product.x;
      q[1][i] = product.y;
      q[2][i] = product.z;
      q[3][i] = product.w;
    }
    lay_out(q, here, target.orientation, at, target.planes);
  }
}

}  // namespace

#define ORISPLINE_TEXT_OF(name) #name
#define ORISPLINE_TEXT(name) ORISPLINE_TEXT_OF(name)

extern const Kernels ORISPLINE_KERNELS;
const Kernels ORISPLINE_KERNELS{ORISPLINE_TEXT(ORISPLINE_KERNELS),
                                &cumulative<double>,
                                &cumulative<float>,
                                &chart<double>,
                                &chart<float>,
                                &bundle<double>,
                                &bundle<float>};

}  // namespace orispline::batch
