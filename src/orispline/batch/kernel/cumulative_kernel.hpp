// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/batch/kernel/block.hpp>
#include <orispline/batch/kernel/trigonometry.hpp>
#include <orispline/batch/kernel/vector.hpp>

// Samples of a cumulative segment. In an anonymous namespace, so that every instruction set has its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

/// What the angle of one factor makes of every sample of a block. Each factor has a loop of its own: in one loop for
/// all, the sums of one step wait for each other longer than the processor looks ahead.
template <class T>
struct FactorPlanes {
  alignas(64) Plane<T> sine, cosine, first, second, third;  ///< the derivatives are those of the angle
};

template <int Degree, class Range, Rates Wanted, class T>
[[gnu::always_inline]] inline void turn_factor(const CumulativeRecord<T>& r, int factor, const Plane<T>& s, int padded,
                                               FactorPlanes<T>& to) {
  const auto coefficient = [&](int k) __attribute__((always_inline)) { return r.angles[k][factor]; };
  for (int i = 0; i < padded; ++i) {
    Taylor<T> angle{};
    if constexpr (Wanted == Rates::none) angle.value = value<Degree, T>(s[i], coefficient);
    else angle = taylor<Degree, T>(s[i], coefficient);
    const Circle<T> circle = Range::at(angle.value);
    to.sine[i] = circle.sine;
    to.cosine[i] = circle.cosine;
    if constexpr (Wanted != Rates::none) to.first[i] = angle.first;
    if constexpr (Wanted >= Rates::second) to.second[i] = angle.second;
    if constexpr (Wanted >= Rates::third) to.third[i] = angle.third;
  }
}

/// M exp(a x_a) exp(b x_b) exp(c x_c); `row(j)` is products[j], or one component of it.
template <class V, class T, class Row>
[[gnu::always_inline]] inline V product(Circle<T> a, Circle<T> b, Circle<T> c, Row row) {
  const T w0 = a.cosine * b.cosine, w1 = a.sine * b.cosine, w2 = a.cosine * b.sine, w3 = a.sine * b.sine;
  const V straight = w3 * row(3) + (w2 * row(2) + (w1 * row(1) + w0 * row(0)));
  const V turned = w3 * row(7) + (w2 * row(6) + (w1 * row(5) + w0 * row(4)));
  return c.sine * turned + c.cosine * straight;
}

/// The body rates of exp(a x_a) exp(b x_b) exp(c x_c): twice the half rates, first in the frame after b, then turned by
/// the last factor. Derivation: docs/performance.md.
template <Rates Wanted, class T>
[[gnu::always_inline]] inline BodyRates<T> rates(const CumulativeRecord<T>& r, const Taylor<T>& a, const Taylor<T>& b,
                                                 const Taylor<T>& c, Circle<T> cb, Circle<T> cc, T per_step) {
  const Vector<T> axis_b = vector(r.axis_b), axis_c = vector(r.axis_c);
  const Vector<T> p1 = vector(r.carried[1]), p2 = vector(r.carried[2]);
  const T cos_b = T(1) - T(2) * cb.sine * cb.sine, sin_b = T(2) * cb.sine * cb.cosine;
  const T versine_c = T(2) * cc.sine * cc.sine, cos_c = T(1) - versine_c, sin_c = T(2) * cc.sine * cc.cosine;
  const Vector<T> axis_a = vector(r.carried[0]) + (cos_b * p1 + sin_b * p2);
  const auto turned = [&](Vector<T> v) {
    return cos_c * v + (sin_c * cross(v, axis_c) + (versine_c * dot(axis_c, v)) * axis_c);
  };
  const Vector<T> before = turned(a.first * axis_a + b.first * axis_b);
  BodyRates<T> body{.omega = (T(2) * per_step) * (before + c.first * axis_c), .alpha = {}, .jerk = {}};
  if constexpr (Wanted == Rates::none || Wanted == Rates::first) return body;
  const Vector<T> slope = cos_b * p2 - sin_b * p1, axis_a_rate = (T(2) * b.first) * slope;
  const Vector<T> rate = (a.second * axis_a + a.first * axis_a_rate) + b.second * axis_b;
  const Vector<T> turned_rate = turned(rate), turn = cross(before, axis_c);
  body.alpha = (T(2) * per_step * per_step) * (turned_rate + ((T(2) * c.first) * turn + c.second * axis_c));
  if constexpr (Wanted == Rates::third) {
    const Vector<T> bend = (T(2) * b.second) * slope - (T(4) * b.first * b.first) * (cos_b * p1 + sin_b * p2);
    const Vector<T> rate_rate =
        (a.third * axis_a + (T(2) * a.second) * axis_a_rate) + (a.first * bend + b.third * axis_b);
    const Vector<T> turns = (T(2) * c.second) * turn + (T(4) * c.first) * cross(turned_rate, axis_c);
    const Vector<T> bent = (T(4) * c.first * c.first) * cross(turn, axis_c) + c.third * axis_c;
    body.jerk = (T(2) * per_step * per_step * per_step) * (turned(rate_rate) + (turns + bent));
  }
  return body;
}

template <class T>
struct CumulativePlanes {
  alignas(64) Plane<T> s;
  FactorPlanes<T> factors[3];
  OutputPlanes<T> out;

  [[gnu::always_inline]] Circle<T> circle(int factor, int i) const {
    return {factors[factor].sine[i], factors[factor].cosine[i]};
  }
  template <Rates Wanted>
  [[gnu::always_inline]] Taylor<T> angle(int factor, int i) const {
    Taylor<T> angle{.value = T(0), .first = factors[factor].first[i], .second = T(0), .third = T(0)};
    if constexpr (Wanted >= Rates::second) angle.second = factors[factor].second[i];
    if constexpr (Wanted >= Rates::third) angle.third = factors[factor].third[i];
    return angle;
  }
};

template <int Degree, class Outer, class Inner, Rates Wanted, class T>
void cumulative_block(const CumulativeRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  CumulativePlanes<T> p;
  const T per_step = static_cast<T>(r.per_step);
  in_blocks(
      count, [&](std::size_t at, int here, int padded) __attribute__((always_inline)) {
        local_times<T>(r, clock, at, here, padded, p.s);
        turn_factor<Degree, Outer, Wanted>(r, 0, p.s, padded, p.factors[0]);
        turn_factor<Degree, Inner, Wanted>(r, 1, p.s, padded, p.factors[1]);
        turn_factor<Degree, Outer, Wanted>(r, 2, p.s, padded, p.factors[2]);
        for (int i = 0; target.orientation && i < padded; ++i) {
          const Circle<T> a = p.circle(0, i), b = p.circle(1, i), c = p.circle(2, i);
#pragma GCC unroll 4
          for (int k = 0; k < 4; ++k)
            p.out.q[k][i] = product<T>(
                a, b, c, [&](int j) __attribute__((always_inline)) { return r.products[j][k]; });
        }
        if constexpr (Wanted != Rates::none)
          for (int i = 0; i < padded; ++i)
            p.out.template store<Wanted>(
                i, rates<Wanted>(r, p.template angle<Wanted>(0, i), p.template angle<Wanted>(1, i),
                                 p.template angle<Wanted>(2, i), p.circle(1, i), p.circle(2, i), per_step));
        lay_out<Wanted>(p.out, here, target, at);
      });
}

/// One sample: the three factors are lanes.
template <class Range, Rates Wanted, class T>
[[gnu::always_inline]] inline void cumulative_point(const CumulativeRecord<T>& r, T s, const Target<T>& target,
                                                    std::size_t at) {
  using V = Lanes<T>;
  Taylor<V> x{};
  const auto coefficient = [&](int k) __attribute__((always_inline)) { return lanes_at(r.angles[k]); };
  if constexpr (Wanted == Rates::none) x.value = value<record_degree, V>(V{} + s, coefficient);
  else x = taylor<record_degree, V>(V{} + s, coefficient);
  const Circle<V> all = Range::at(x.value);
  const auto circle = [&](int k) __attribute__((always_inline)) { return Circle<T>{all.sine[k], all.cosine[k]}; };
  const Circle<T> a = circle(0), b = circle(1), c = circle(2);
  put<T>(product<V>(
             a, b, c, [&](int j) __attribute__((always_inline)) { return lanes_at(r.products[j]); }),
         at, target);
  if constexpr (Wanted != Rates::none) {
    const auto angle = [&](int k) __attribute__((always_inline)) {
      return Taylor<T>{T(0), x.first[k], x.second[k], x.third[k]};
    };
    put(rates<Wanted>(r, angle(0), angle(1), angle(2), b, c, static_cast<T>(r.per_step)), at, target);
  }
}

template <int Degree, Rates Wanted, class T>
void cumulative_block_of(const CumulativeRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  if (r.range == AngleRange::any) cumulative_block<Degree, Any, Any, Wanted>(r, clock, count, target);
  else if (Wanted == Rates::none && r.range == AngleRange::narrow)
    cumulative_block<Degree, Narrow, Wide, Rates::none>(r, clock, count, target);
  else cumulative_block<Degree, Wide, Wide, Wanted>(r, clock, count, target);
}

template <Rates Wanted, class T>
[[gnu::always_inline]] inline void cumulative_point_of(const CumulativeRecord<T>& r, T s, const Target<T>& target,
                                                       std::size_t at) {
  if (r.range == AngleRange::any) cumulative_point<Any, Wanted>(r, s, target, at);
  else if (Wanted == Rates::none && r.range == AngleRange::narrow)
    cumulative_point<NarrowWideNarrow, Rates::none>(r, s, target, at);
  else cumulative_point<Wide, Wanted>(r, s, target, at);
}

template <class T>
void cumulative(const CumulativeRecord<T>& r, const Clock& clock, std::size_t count, const Target<T>& target) {
  if (count <= most_points) {
    for (std::size_t i = 0; i < count; ++i) {
      const T s = local_time<T>(r, clock, i);
      by_rates_of_points(target, [&]<Rates Wanted>() { cumulative_point_of<Wanted>(r, s, target, i); });
    }
    return;
  }
  by_rates(target, [&]<Rates Wanted>() {
    if (r.short_degree) cumulative_block_of<5, Wanted>(r, clock, count, target);
    else cumulative_block_of<record_degree, Wanted>(r, clock, count, target);
  });
}

}  // namespace

}}}  // namespace orispline::batch
