// SPDX-License-Identifier: Apache-2.0
// Tan et al. 2018, section 3: what theorem 1 rests on.
#include "papers/experiment.hpp"

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/families/quintic.hpp>

#include "papers/identities.hpp"
#include "papers/random_spline.hpp"

namespace orispline::cli {

namespace quintic_lemmas { namespace {

struct Spline : RandomSpline<families::Quintic> {
  explicit Spline(Dice& dice) : RandomSpline(dice, -1.0, 2.0) {}
};
struct Segment : RandomSegment<families::Quintic> {
  explicit Segment(Dice& dice) : RandomSegment(dice, -1.0, 2.0) {}
};

/// (3.4), which (3.2) is made to fulfil.
double error_in_space(Dice& dice) {
  const Segment s(dice);
  const auto& p = s.p;
  const double a = s.start_tension, b = s.end_tension;
  return std::max({s.error(0, p[1], p[2]), s.error(1, a * (p[2] - p[0]), b * (p[3] - p[1])),
                   s.error(2, a * (p[2] - 2.0 * p[1] + p[0]), b * (p[3] - 2.0 * p[2] + p[1]))});
}

double error_of_interpolation(Dice& dice) {
  const Spline s(dice);
  return s.error(0, s.q());
}

double error_of_rate(Dice& dice) {
  const Spline s(dice);
  return s.error(1, s.tension() * (s.q() * (s.a() + s.b())));
}

/// The first line, in which the logarithm before the key is that of 1.
double error_of_printed_rate(Dice& dice) {
  const Spline s(dice);
  return gap(s.after(1), s.tension() * (s.q() * s.b()));
}

double error_of_second(Dice& dice) {
  const Spline s(dice);
  const AnyQuaternion a = s.a(), b = s.b(), square = a * a + 2.0 * (a * b) + b * b;
  return s.error(2, s.tension() * (s.q() * (s.tension() * square + (b - a))));
}

double error_of_printed_second(Dice& dice) {
  const Spline s(dice);
  const AnyQuaternion a = s.a(), b = s.b();
  return s.error(2, s.tension() * (s.q() * (s.tension() * ((a + b) * (a + b)) + (b - a))));
}

/// In the local parameters the ratio of (3.14) is 1.
double error_of_joining(Dice& dice) {
  const Spline s(dice);
  return std::max({gap(s.before(0), s.after(0)), gap(s.before(1), s.after(1)), gap(s.before(2), s.after(2))});
}

/// "Is of C² continuity": q' in time, on these uneven knots.
double error_of_c2(Dice& dice) {
  const Spline s(dice);
  return gap(s.ratio_of_steps() * s.before(1), s.after(1));
}

constexpr std::array identities{
    Identity{"(3.4)", "p, p', p'' at both ends of a segment in space", error_in_space},
    Identity{"(3.11)", "q = Q at the key, from both sides", error_of_interpolation},
    Identity{"(3.12)", "h q' = α Q (A + B), from both sides", error_of_rate},
    Identity{"(3.13)", "h² q'' = α Q {α (A² + 2AB + B²) + (B − A)}, from both sides", error_of_second},
    Identity{"(3.14)", "h^m q^(m) is the same on both sides, m = 0, 1, 2: G² where α is not 0", error_of_joining}};

constexpr std::array misprints{
    Misprint{"(3.12)", "first line: log(Q_i⁻¹ Q_i), which is 0, for A", error_of_printed_rate, "A = log(Q_(i−1)⁻¹ Q_i)",
             error_of_rate},
    Misprint{"(3.13)", "α (A + B)² + (B − A)", error_of_printed_second, "α (A² + 2AB + B²) + (B − A)", error_of_second},
    Misprint{"theorem 1", "end of its proof: C², so that q' is continuous in time", error_of_c2,
             "G²: continuous in the local parameters", error_of_joining}};

}}  // namespace quintic_lemmas

Expected<Findings> experiment::quintic_identities() {
  const std::array<std::span<const Identity>, 1> parts{quintic_lemmas::identities};
  return Findings{
      {identities_table(formatted("Tan's derivatives at a key on {} random draws each", draws_of_identities), parts,
                        {"Keys, uneven knots and tensions from −1 to 2 are drawn at random. Q is the key, h the step "
                         "of the segment, α the tension.",
                         "A and B are the half-angle logarithms of the increments before and behind the key.",
                         "Theorem 1 does not follow where α is 0: q' and q'' vanish there (000-theorem1)."}),
       misprints_table(quintic_lemmas::misprints)}};
}

}  // namespace orispline::cli
