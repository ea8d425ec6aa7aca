// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <orispline/batch/kernel/polynomial.hpp>

// Sine and cosine for the kernel's loops: no branches, no calls. In an anonymous namespace, so that every instruction
// set has its own.
//
// cos x = 1 + u P(u), sin x = x + x u R(u), u = x²: the coefficients interpolate at Chebyshev nodes, computed with 60
// digits by tools/make_golden.py kernel. Errors: below 0.02 ulp in double, 0.5 ulp in float, before rounding.

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch { namespace {

template <class T>
struct Series;

template <>
struct Series<double> {
  static constexpr double cos_narrow[] = {-0.49999999999999999611, 0.041666666666663558436, -0.0013888888884910209784,
                                          0.0000248015694756836552, -2.7524717487900134821e-7};
  static constexpr double sin_narrow[] = {-0.16666666666666368261, 0.0083333333318054795577, -0.00019841257617613104067,
                                          2.7526021333363913907e-6};
  static constexpr double cos_wide[] = {
      -0.49999999999999999423,   0.041666666666666101387,  -0.0013888888888798428726, 0.000024801587247292685458,
      -2.7557303701922225818e-7, 2.0874477943664775885e-9, -1.1304620460700782401e-11};
  static constexpr double sin_wide[] = {
      -0.16666666666666666633,   0.0083333333333333000416,  -0.00019841269841216566409, 2.7557319192011219391e-6,
      -2.5052099244914113506e-8, 1.6057701922579786979e-10, -7.5493717041812434104e-13};
  // The right Jacobian I - A [φ]× + B [φ]×² and the derivatives of A and B, in x = ‖φ‖² ≤ 4.
  static constexpr double versine[] = {0.5,
                                       -0.041666666666666666581,
                                       0.0013888888888888881809,
                                       -0.000024801587301585035156,
                                       2.7557319223617392336e-7,
                                       -2.0876756953446339185e-9,
                                       1.1470743639492902631e-11,
                                       -4.779408335205851242e-14,
                                       1.5604495247288807555e-16,
                                       -3.9360396760749893811e-19};
  static constexpr double sine_defect[] = {
      0.16666666666666666667,   -0.0083333333333333333296,  0.00019841269841269838183, -2.7557319223984902427e-6,
      2.5052108385281050613e-8, -1.6059043821814461257e-10, 7.6471628781566010295e-13, -2.8114271808703429887e-15,
      8.214224669855812691e-18, -1.8813952983715250641e-20};
  static constexpr double versine_slope[] = {
      -0.041666666666666666667,   0.0027777777777777777761,  -0.000074404761904761890615, 1.1022927689593903428e-6,
      -1.0438378493860426595e-8,  6.8824473517610771492e-11, -3.3456337414921956935e-13,  1.2495227765699898568e-15,
      -3.6963482035211648237e-18, 8.5489683018954961374e-21};
  static constexpr double sine_defect_slope[] = {
      -0.0083333333333333333333,  0.00039682539682539682533, -8.2671957671957666285e-6,  1.0020843354176505932e-7,
      -8.0295219183812869919e-10, 4.5882982363346991263e-12, -1.9680199212148081112e-14, 6.5764529559332438084e-17,
      -1.7603873993666122226e-19, 3.7288428042423145836e-22};
  static constexpr double versine_curvature[] = {
      0.0027777777777777777778,  -0.00014880952380952380949, 3.3068783068783066165e-6,  -4.1753513975735360061e-8,
      3.4412236793052951049e-10, -2.0073804783303754742e-12, 8.7467551787134075408e-15, -2.9594031968189026581e-17,
      8.0016793460777343098e-20, -1.708613204311206753e-22};
  static constexpr double sine_defect_curvature[] = {
      0.0003968253968253968254,  -0.00001653439153439153439, 3.0062530062530061558e-7,  -3.2118087673642918206e-9,
      2.2941491195408890769e-11, -1.180812046352923311e-13,  4.6035554695466355392e-16, -1.4092422976188700062e-18,
      3.4793376498801870667e-21, -6.8532099996508821962e-24};
  // asin √y = √y (1 + y P(y)), y ≤ sin² ½.
  static constexpr double arcsine[] = {0.16666666666666667004,   0.074999999999995049564, 0.044642857144059489681,
                                       0.030381944330026663896,  0.022372164730139545775, 0.017352599645571738219,
                                       0.013967919352068542054,  0.011513581433981305977, 0.010083720176908386707,
                                       0.0065524535215493376714, 0.014227395986381845357, -0.0095775278475477101722,
                                       0.024928640141173572637};
  using Bits = std::uint64_t;
  static constexpr int sign_shift = 62;
  static constexpr double round = 6755399441055744.0;  // 1.5 · 2⁵²: adding it rounds to an integer
  static constexpr double quarter_turn[] = {1.57079632673412561417e+00, 6.07710050630396597660e-11,
                                            2.02226624879595063154e-21};
};

template <>
struct Series<float> {
  static constexpr float cos_narrow[] = {-0.49999999981097590583f, 0.041666612225626580677f,
                                         -0.0013865655557261421726f};
  static constexpr float sin_narrow[] = {-0.16666656986952273821f, 0.008320941954102525168f};
  static constexpr float cos_wide[] = {-0.49999999787945913583f, 0.041666598793227254445f, -0.0013885490860454661809f,
                                       0.000024256144914672251378f};
  static constexpr float sin_wide[] = {-0.16666666647343993721f, 0.0083333271488352663715f, -0.00019838174236287689275f,
                                       2.7060668539683607926e-6f};
  static constexpr float versine[] = {0.49999999997817791087f,   -0.041666666273777148321f,
                                      0.0013888877415744554131f, -0.000024800360433663780801f,
                                      2.7497883274629852096e-7f, -1.9542444949249929369e-9f};
  static constexpr float sine_defect[] = {0.16666666666520325025f,    -0.0083333333069864087753f,
                                          0.00019841262148559687133f, -2.7556496857639529823e-6f,
                                          2.5012291273062737149e-8f,  -1.5166245736457594431e-10f};
  static constexpr float versine_slope[] = {-0.041666666666026872424f,    0.0027777777662590695289f,
                                            -0.000074404728272143246243f, 1.1022568137291059567e-6f,
                                            -1.0420968606812594858e-8f,   6.4920184116139573843e-11f};
  static constexpr float sine_defect_slope[] = {-0.0083333333332955200023f,  0.00039682539614462949626f,
                                                -8.2671937797028640529e-6f,  1.002063093020620191e-7f,
                                                -8.0192408108382462865e-10f, 4.3579599723493397219e-12f};
  static constexpr float versine_curvature[] = {0.0027777777777609803071f,  -0.00014880952350711203819f,
                                                3.306877423979566612e-6f,   -4.1752570306401299277e-8f,
                                                3.4366561931727910958e-10f, -1.9050398466211674265e-12f};
  static constexpr float sine_defect_curvature[] = {0.00039682539682450931729f, -0.000016534391518413652318f,
                                                    3.0062525398186654745e-7f,  -3.2117589231369618454e-9f,
                                                    2.2917374891691101628e-11f, -1.1268189704122200092e-13f};
  static constexpr float arcsine[] = {0.16666666479433541162f,  0.075000584936726537322f, 0.044613577646644532671f,
                                      0.030910019958284172505f, 0.018177736861957948239f, 0.031774592193962007348f};
  using Bits = std::uint32_t;
  static constexpr int sign_shift = 30;
  static constexpr float round = 12582912.0f;  // 1.5 · 2²³
  static constexpr float quarter_turn[] = {1.5703125f, 4.837512969970703125e-4f, 7.549789954891882e-8f};
};

/// The integers that hold the bits of a number or of its lanes.
template <class V>
struct BitsOf {
  using Type = typename Series<V>::Bits;
};
template <>
struct BitsOf<Lanes<double>> {
  using Type [[gnu::vector_size(32)]] = std::uint64_t;
};
template <>
struct BitsOf<Lanes<float>> {
  using Type [[gnu::vector_size(16)]] = std::uint32_t;
};
template <class V>
using SeriesOf = Series<Element<V>>;

template <class V>
struct Circle {
  V sine, cosine;
};

template <class V>
[[gnu::always_inline]] inline Circle<V> circle(const V& x, const V& u, const V& sine_tail, const V& cosine_tail) {
  return {x + x * u * sine_tail, Element<V>(1) + u * cosine_tail};
}

/// |x| ≤ 0.25
struct Narrow {
  template <class V>
  [[gnu::always_inline]] static inline Circle<V> at(const V& x) {
    const V u = x * x;
    return circle<V>(x, u, polynomial(SeriesOf<V>::sin_narrow, u), polynomial(SeriesOf<V>::cos_narrow, u));
  }
};

/// |x| ≤ 1
struct Wide {
  template <class V>
  [[gnu::always_inline]] static inline Circle<V> at(const V& x) {
    const V u = x * x;
    return circle<V>(x, u, polynomial(SeriesOf<V>::sin_wide, u), polynomial(SeriesOf<V>::cos_wide, u));
  }
};

/// Lanes 0 and 2 narrow, lane 1 wide: a short series with zeros on top gives the same bits.
struct NarrowWideNarrow {
  template <class V>
  [[gnu::always_inline]] static inline Circle<V> at(const V& x) {
    using S = SeriesOf<V>;
    const V u = x * x;
    return circle<V>(x, u, mixed(S::sin_narrow, S::sin_wide, u), mixed(S::cos_narrow, S::cos_wide, u));
  }

 private:
  template <class T, int Short, int Long, class V>
  [[gnu::always_inline]] static inline V mixed(const T (&narrow)[Short], const T (&wide)[Long], const V& u) {
    return value<Long - 1>(
        u, [&](int k) __attribute__((always_inline)) {
          const T outer = k < Short ? narrow[k] : T(0);
          return V{outer, wide[k], outer, T(0)};
        });
  }
};

/// Any angle up to some 10⁵: the nearest quarter turn is taken off, sine and cosine change places as it says.
struct Any {
  template <class V>
  [[gnu::always_inline]] static inline Circle<V> at(const V& x) {
    using S = SeriesOf<V>;
    using Bits = typename BitsOf<V>::Type;
    const V shifted = x * Element<V>(0.63661977236758134308) + S::round;
    const Bits quarter = __builtin_bit_cast(Bits, shifted);
    const V turns = shifted - S::round;
    const V r = ((x - turns * S::quarter_turn[0]) - turns * S::quarter_turn[1]) - turns * S::quarter_turn[2];
    const Circle<V> folded = Wide::at(r);
    const Bits swap = Bits{} - (quarter & 1);
    Bits sine = __builtin_bit_cast(Bits, folded.sine), cosine = __builtin_bit_cast(Bits, folded.cosine);
    const Bits difference = (sine ^ cosine) & swap;
    sine = (sine ^ difference) ^ ((quarter & 2) << S::sign_shift);
    cosine = (cosine ^ difference) ^ (((quarter + 1) & 2) << S::sign_shift);
    return {__builtin_bit_cast(V, sine), __builtin_bit_cast(V, cosine)};
  }
};

}  // namespace

}}}  // namespace orispline::batch
