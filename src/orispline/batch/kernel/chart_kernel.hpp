// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/kernel/block.hpp>
#include <orispline/batch/kernel/trigonometry.hpp>
#include <orispline/batch/kernel/vector.hpp>

// Samples of a chart segment. In an anonymous namespace, so that every instruction set has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

/// base exp(φ), ‖φ‖² ≤ 4, as qx, qy, qz, qw.
template <class T>
struct ChartSample {
  T q[4];
};
template <class T>
[[gnu::always_inline]] inline ChartSample<T> chart_sample(const T (&base)[4], const Vector<T>& phi) {
  const T u = T(0.25) * dot(phi, phi);
  const T w = T(1) + u * polynomial(Series<T>::cos_wide, u);
  const Vector<T> v = (T(0.5) + T(0.5) * u * polynomial(Series<T>::sin_wide, u)) * phi;
  return {{(base[3] * v.x + base[0] * w) + (base[1] * v.z - base[2] * v.y),
           (base[3] * v.y + base[1] * w) + (base[2] * v.x - base[0] * v.z),
           (base[3] * v.z + base[2] * w) + (base[0] * v.y - base[1] * v.x),
           (base[3] * w - base[0] * v.x) - (base[1] * v.y + base[2] * v.z)}};
}

/// ω = J_r(φ) φ̇ and its derivatives: each term is a coefficient in x = ‖φ‖² times φ × φ̇ or φ × (φ × φ̇).
template <Rates Wanted, class T>
[[gnu::always_inline]] inline BodyRates<T> chart_rates(const Taylor<T> (&phi)[3], T per_step) {
  using S = Series<T>;
  const Vector<T> v{phi[0].value, phi[1].value, phi[2].value}, d{phi[0].first, phi[1].first, phi[2].first};
  const T x = dot(v, v);
  const T versine = polynomial(S::versine, x), defect = polynomial(S::sine_defect, x);
  const Vector<T> turn = cross(v, d), tilt = cross(v, turn);
  BodyRates<T> body{.omega = per_step * (d + (defect * tilt - versine * turn)), .alpha = {}, .jerk = {}};
  if constexpr (Wanted == Rates::none || Wanted == Rates::first) return body;
  const Vector<T> d2{phi[0].second, phi[1].second, phi[2].second};
  const T growth = T(2) * dot(v, d);
  const T versine_slope = polynomial(S::versine_slope, x), defect_slope = polynomial(S::sine_defect_slope, x);
  const T versine_rate = growth * versine_slope, defect_rate = growth * defect_slope;
  const Vector<T> turn_rate = cross(v, d2), tilt_rate = cross(d, turn) + cross(v, turn_rate);
  const Vector<T> slope = (defect_rate * tilt - versine_rate * turn) + (defect * tilt_rate - versine * turn_rate);
  body.alpha = (per_step * per_step) * (d2 + slope);
  if constexpr (Wanted == Rates::third) {
    const Vector<T> d3{phi[0].third, phi[1].third, phi[2].third};
    const T growth_rate = T(2) * (dot(d, d) + dot(v, d2)), growth_2 = growth * growth;
    const T versine_bend = growth_rate * versine_slope + growth_2 * polynomial(S::versine_curvature, x),
            defect_bend = growth_rate * defect_slope + growth_2 * polynomial(S::sine_defect_curvature, x);
    const Vector<T> turn_bend = cross(d, d2) + cross(v, d3);
    const Vector<T> tilt_bend = cross(d2, turn) + (T(2) * cross(d, turn_rate) + cross(v, turn_bend));
    const Vector<T> bend =
        (defect_bend * tilt - versine_bend * turn) +
        (T(2) * (defect_rate * tilt_rate - versine_rate * turn_rate) + (defect * tilt_bend - versine * turn_bend));
    body.jerk = (per_step * per_step * per_step) * (d3 + bend);
  }
  return body;
}

template <int Degree, Rates Wanted, class T>
void chart_block(const ChartRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  const T per_step = static_cast<T>(r.per_step);
  alignas(64) Plane<T> s, values[3];
  OutputPlanes<T> out;
  in_blocks(
      count, [&](std::size_t at, int here, int padded) __attribute__((always_inline)) {
        local_times<T>(r, clock, at, here, padded, s);
        for (int i = 0; i < padded; ++i) {
          Taylor<T> phi[3]{};
#pragma GCC unroll 3
          for (int k = 0; k < 3; ++k) {
            const auto coefficient = [&](int power) __attribute__((always_inline)) {
              return r.rotation_vector[power][k];
            };
            if constexpr (Wanted == Rates::none) phi[k].value = value<Degree, T>(s[i], coefficient);
            else phi[k] = taylor<Degree, T>(s[i], coefficient);
            values[k][i] = phi[k].value;
          }
          if constexpr (Wanted != Rates::none) out.template store<Wanted>(i, chart_rates<Wanted>(phi, per_step));
        }
        for (int i = 0; target.orientation && i < padded; ++i) {
          const ChartSample<T> sample = chart_sample(r.base, {values[0][i], values[1][i], values[2][i]});
#pragma GCC unroll 4
          for (int k = 0; k < 4; ++k) out.q[k][i] = sample.q[k];
        }
        lay_out<Wanted>(out, here, target, at);
      });
}

/// One sample: the three components of φ are lanes.
template <Rates Wanted, class T>
[[gnu::always_inline]] inline void chart_point(const ChartRecord<T>& r, T s, const Target<T>& target, std::size_t at) {
  using V = Lanes<T>;
  Taylor<V> all{};
  const auto coefficient = [&](int k) __attribute__((always_inline)) { return lanes_at(r.rotation_vector[k]); };
  if constexpr (Wanted == Rates::none) all.value = value<record_degree, V>(V{} + s, coefficient);
  else all = taylor<record_degree, V>(V{} + s, coefficient);
  const ChartSample<T> sample = chart_sample(r.base, {all.value[0], all.value[1], all.value[2]});
  put<T>(lanes_at(sample.q), at, target);
  if constexpr (Wanted != Rates::none) {
    Taylor<T> phi[3];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) phi[k] = {all.value[k], all.first[k], all.second[k], all.third[k]};
    put(chart_rates<Wanted>(phi, static_cast<T>(r.per_step)), at, target);
  }
}

template <class T>
void chart(const ChartRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  if (count <= most_points) {
    for (std::size_t i = 0; i < count; ++i) {
      const T s = local_time<T>(r, clock, i);
      by_rates_of_points(target, [&]<Rates Wanted>() { chart_point<Wanted>(r, s, target, i); });
    }
    return;
  }
  by_rates(target, [&]<Rates Wanted>() {
    if (r.short_degree) chart_block<5, Wanted>(r, clock, count, target);
    else chart_block<record_degree, Wanted>(r, clock, count, target);
  });
}

}  // namespace

}}}  // namespace orispline::batch
