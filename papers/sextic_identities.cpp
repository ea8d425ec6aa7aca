// SPDX-License-Identifier: Apache-2.0
// The 6th degree, section 3: lemmas 1 to 4, and what theorem 1 rests on.
#include "papers/experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/families/sextic.hpp>

#include "papers/identities.hpp"
#include "papers/random_spline.hpp"

namespace orispline::cli {

namespace sextic_lemmas { namespace {

struct Spline : RandomSpline<families::Sextic> {
  explicit Spline(Dice& dice) : RandomSpline(dice, -0.1, 0.3) {}
};
struct Segment : RandomSegment<families::Sextic> {
  explicit Segment(Dice& dice) : RandomSegment(dice, -0.1, 0.3) {}
};

double third(double beta) { return 30.0 - 360.0 * beta; }
double printed_third(double beta) { return 0.25 - 3.0 * beta; }

double error_in_space(Dice& dice) {
  const Segment s(dice);
  const auto& p = s.p;
  return std::max({s.error(0, p[1], p[2]),
                   s.error(1, 6.0 * s.start_tension * (p[2] - p[0]), 6.0 * s.end_tension * (p[3] - p[1])),
                   s.error(2, 2.5 * (p[2] - 2.0 * p[1] + p[0]), 2.5 * (p[3] - 2.0 * p[2] + p[1]))});
}

double error_of_third_in_space(Dice& dice, double (*factor)(double)) {
  const Segment s(dice);
  return s.error(3, factor(s.start_tension) * (s.p[2] - s.p[0]), factor(s.end_tension) * (s.p[3] - s.p[1]));
}

/// The derivatives of an order of the sums C̃₁, C̃₂, C̃₃ at t = 0, then at t = 1.
using Sums = std::array<double, 6>;

/// Of random tensions: how far lemma 1 is from the sums themselves.
double error_of_lemma1(Dice& dice, std::size_t order, Sums (*stated)(double beta1, double beta2)) {
  const double beta1 = dice.between(-0.1, 0.3), beta2 = dice.between(-0.1, 0.3);
  const families::Sextic::Basis basis{PerKey({beta1, beta2})};
  const Knots knots({0.0, 1.0});
  const Sums wanted = stated(beta1, beta2);
  double largest = 0.0;
  for (const std::size_t end : {0U, 1U}) {
    const auto sums = basis(knots.span(0), Jet<double, 3>::variable(static_cast<double>(end)));
    for (std::size_t k = 0; k < 3; ++k)
      largest = std::max(largest, std::abs(sums[k].derivative(order) - wanted[3 * end + k]));
  }
  return largest;
}

double error_of_lemma1_i(Dice& dice) {
  return error_of_lemma1(dice, 0, [](double, double) { return Sums{1, 0, 0, 1, 1, 0}; });
}
double error_of_lemma1_ii(Dice& dice) {
  return error_of_lemma1(dice, 1, [](double b1, double b2) { return Sums{6 * b1, 6 * b1, 0, 0, 6 * b2, 6 * b2}; });
}
double error_of_lemma1_iii(Dice& dice) {
  return error_of_lemma1(dice, 2, [](double, double) { return Sums{-2.5, 2.5, 0, 0, -2.5, 2.5}; });
}
double error_of_printed_lemma1_iii(Dice& dice) {
  return error_of_lemma1(dice, 2, [](double, double) { return Sums{-2.5, -2.5, 0, 0, 2.5, 2.5}; });
}
double error_of_lemma1_iv(Dice& dice) {
  return error_of_lemma1(dice, 3,
                         [](double b1, double b2) { return Sums{third(b1), third(b1), 0, 0, third(b2), third(b2)}; });
}
double error_of_printed_lemma1_iv(Dice& dice) {
  return error_of_lemma1(dice, 3, [](double b1, double b2) {
    const double start = -(360 * b1 + 30), end = -(360 * b2 + 30);
    return Sums{start, start, 0, 0, end, end};
  });
}

/// C_j(t; β, β) = C_(3−j)(1 − t; β, β).
double error_of_symmetry(Dice& dice) {
  const double beta = dice.between(-0.1, 0.3), t = dice.between(0.0, 1.0);
  const families::Sextic::Basis basis{PerKey({beta, beta})};
  const Knots knots({0.0, 1.0});
  const auto functions_at = [&](double at) {
    const auto sums = basis(knots.span(0), Jet<double, 3>::variable(at));
    const auto s = [&](std::size_t k) { return sums[k].derivative(0); };
    return std::array{1.0 - s(0), s(0) - s(1), s(1) - s(2), s(2)};
  };
  const auto here = functions_at(t), mirrored = functions_at(1.0 - t);
  double largest = 0.0;
  for (std::size_t j = 0; j < 4; ++j) largest = std::max(largest, std::abs(here[j] - mirrored[3 - j]));
  return largest;
}

double error_of_lemma2(Dice& dice) {
  const Spline s(dice);
  return std::max(s.error(0, s.q()), s.error(1, 6.0 * s.tension() * (s.q() * (s.a() + s.b()))));
}

double error_of_lemma3(Dice& dice) {
  const Spline s(dice);
  const AnyQuaternion a = s.a(), b = s.b(), square = a * a + 2.0 * (a * b) + b * b;
  return s.error(2, s.q() * (36.0 * s.tension() * s.tension() * square + 2.5 * (b - a)));
}

double error_of_printed_lemma3(Dice& dice) {
  const Spline s(dice);
  const AnyQuaternion a = s.a(), b = s.b(), sum = 6.0 * s.tension() * (a + b);
  return s.error(2, s.q() * (sum * sum + 2.5 * (b - a)));
}

double error_of_lemma4(Dice& dice) {
  const Spline s(dice);
  const double w = 6.0 * s.tension();
  const AnyQuaternion a = s.a(), b = s.b(), cube = a * a * a + 3.0 * (a * a * b) + 3.0 * (a * b * b) + b * b * b;
  return s.error(3, s.q() * (w * w * w * cube + 7.5 * w * (b * b - a * a) + third(s.tension()) * (a + b)));
}

double error_of_printed_lemma4(Dice& dice) {
  const Spline s(dice);
  const double w = 6.0 * s.tension();
  const AnyQuaternion a = s.a(), b = s.b(), sum = a + b;
  return s.error(
      3, w * (s.q() * (w * w * (sum * sum * sum) + 7.5 * (b * b - a * a) + third(s.tension()) * (s.q() * sum))));
}

/// In the local parameters the ratio of (9) is 1.
double error_of_joining(Dice& dice) {
  const Spline s(dice);
  return std::max({gap(s.before(0), s.after(0)), gap(s.before(1), s.after(1)), gap(s.before(2), s.after(2)),
                   gap(s.before(3), s.after(3))});
}

/// (9) with the steps behind the key and the next one, of which that curve knows nothing; as large as the others are.
double error_of_printed_9(Dice& dice) {
  const Spline s(dice);
  const double printed = dice.between(0.5, 2.0) / dice.between(0.5, 2.0);
  return gap(s.ratio_of_steps() * s.before(1), printed * s.after(1));
}

double error_of_factor(Dice& dice, double middle) {
  const AnyQuaternion log = half_log(dice.unit_quaternion());
  const double t = dice.between(0.0, 1.0);
  const auto s = Jet<double, 3>::variable(t);
  const auto f = s * s * (s - Jet<double, 3>(0.5));
  const auto power = pow<Jet<double, 3>>(constant<Jet<double, 3>>(half_exp(log.vector()).coefficients()), f);
  const double f1 = f.derivative(1), f2 = f.derivative(2), f3 = f.derivative(3);
  const AnyQuaternion rate = f1 * f1 * f1 * (log * log * log) + middle * f1 * f2 * (log * log) + f3 * log;
  return gap(derivative(power, 3), derivative(power, 0) * rate);
}

/// The coefficients of C₀ + C₁ + C₂ + C₃, which is to be 1.
using Coefficients = BernsteinRows<1, 7>;
constexpr double twelfth = 1.0 / 12.0;

double error_of_sum(Dice& dice, Coefficients (*summed)(double beta1, double beta2)) {
  const double beta1 = dice.between(-0.1, 0.3), beta2 = dice.between(-0.1, 0.3), t = dice.between(0.0, 1.0);
  return std::abs(bernstein_sums(summed(beta1, beta2), t)[0] - 1.0);
}

double error_of_functions(Dice& dice) {
  return error_of_sum(dice, [](double b1, double b2) {
    return Coefficients{{{1.0, -b1 + 1.0 + b1, twelfth - 2 * b1 + 5.0 / 6.0 + 2 * b1 + twelfth, 0.5 + 0.5,
                          2 * b2 + twelfth + 5.0 / 6.0 + twelfth - 2 * b2, b2 + 1.0 - b2, 1.0}}};
  });
}

double error_of_functions_in_abstract(Dice& dice) {
  return error_of_sum(dice, [](double b1, double b2) {
    return Coefficients{{{-b1 + 1.0, 1.0 + b1 + twelfth - 2 * b2, twelfth - 2 * b1 + 5.0 / 6.0 + 2 * b1 + twelfth - b2,
                          0.0, -0.5 + 0.5 + 5.0 / 6.0, 2 * b2 + twelfth + 1.0, b2 + 1.0}}};
  });
}

constexpr std::array identities{
    Identity{"3.1.1", "C₀ + C₁ + C₂ + C₃ = 1", error_of_functions},
    Identity{"3.1.1 (ii)", "C_j(t) = C_(3−j)(1 − t) where both β are the same", error_of_symmetry},
    Identity{"3.1.1", "p, p', p'' at both ends of a segment in space", error_in_space},
    Identity{"3.1.1", "p''' = (30 − 360β)(P_(k+1) − P_(k−1)) at both ends, corrected",
             [](Dice& dice) { return error_of_third_in_space(dice, third); }},
    Identity{"lemma 1 (i)", "C̃_k at both ends", error_of_lemma1_i},
    Identity{"lemma 1 (ii)", "C̃_k' at both ends", error_of_lemma1_ii},
    Identity{"lemma 1 (iii)", "C̃_k'' at both ends, corrected", error_of_lemma1_iii},
    Identity{"lemma 1 (iv)", "C̃_k''' at both ends, corrected", error_of_lemma1_iv},
    Identity{"(2), lemma 2", "q = Q and h q' = 6β Q (A + B), from both sides", error_of_lemma2},
    Identity{"lemma 3", "h² q'' from both sides, corrected", error_of_lemma3},
    Identity{"lemma 4", "h³ q''' from both sides, corrected", error_of_lemma4},
    Identity{"lemma 4", "third derivative of a factor, corrected",
             [](Dice& dice) { return error_of_factor(dice, 3.0); }},
    Identity{"(9)", "h^m q^(m) is the same on both sides, m = 0 … 3: G³ where β is not 0", error_of_joining}};

constexpr std::array misprints{
    Misprint{"abstract", "C₀ + C₁ + C₂ + C₃, which is to be 1", error_of_functions_in_abstract, "as in 3.1.1",
             error_of_functions},
    Misprint{"3.1.1", "p''' with 1/4 − 3β", [](Dice& dice) { return error_of_third_in_space(dice, printed_third); },
             "30 − 360β", [](Dice& dice) { return error_of_third_in_space(dice, third); }},
    Misprint{"lemma 1 (iii)", "C̃₂''(0) = −5/2, C̃₂''(1) = 5/2", error_of_printed_lemma1_iii, "5/2 and −5/2",
             error_of_lemma1_iii},
    Misprint{"lemma 1 (iv)", "−(360β + 30)", error_of_printed_lemma1_iv, "30 − 360β", error_of_lemma1_iv},
    Misprint{"lemma 3", "(6βA + 6βB)²", error_of_printed_lemma3, "36β² (A² + 2AB + B²)", error_of_lemma3},
    Misprint{"lemma 4", "(6β)³ (A + B)³, a Q too many, 6β (30 − 360β)", error_of_printed_lemma4,
             "(6β)³ (A³ + 3A²B + 3AB² + B³), 30 − 360β", error_of_lemma4},
    Misprint{"lemma 4", "f'f'' L² of a factor twice", [](Dice& dice) { return error_of_factor(dice, 2.0); },
             "three times", [](Dice& dice) { return error_of_factor(dice, 3.0); }},
    Misprint{"(9)", "the ratio Δu_(i+1)/Δu_i, for q'", error_of_printed_9, "Δu_i/Δu_(i−1)", error_of_joining}};

}}  // namespace sextic_lemmas

Expected<Findings> experiment::sextic_identities() {
  const std::array<std::span<const Identity>, 1> parts{sextic_lemmas::identities};
  return Findings{
      {identities_table(formatted("The lemmas of the 6th degree on {} random draws each", draws_of_identities), parts,
                        {"Keys, uneven knots and tensions from −0.1 to 0.3 are drawn at random. Q is the key, h the "
                         "step of the segment, β the tension.",
                         "A and B are the half-angle logarithms of the increments before and behind the key.",
                         "Theorem 1 does not follow where β is 0: q' vanishes there (003-theorem1)."}),
       misprints_table(sextic_lemmas::misprints)}};
}

}  // namespace orispline::cli
