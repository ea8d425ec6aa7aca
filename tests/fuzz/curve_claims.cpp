// SPDX-License-Identifier: Apache-2.0
#include <fuzz/curve_claims.hpp>

#include <fuzz/claim.hpp>
#include <fuzz/segment_scale.hpp>
#include <orispline/families/registry.hpp>
#include <support/tolerance.hpp>

namespace orispline::fuzz {

namespace {

/// Ten times a segment, the knots among them, and beside the domain.
std::vector<double> times_around(const Knots& knots) {
  std::vector<double> times{knots.front() - 1.0, knots.back(), knots.back() + 1.0};
  for (std::size_t i = 0; i < knots.segments(); ++i)
    for (int k = 0; k < 10; ++k) times.push_back(knots.span(i).start() + knots.span(i).step() * k / 10.0);
  return times;
}

bool are_even(const Specimen& specimen) {
  const auto times = specimen.keys.times();
  const auto step = [&](std::size_t i) { return times[i + 1] - times[i]; };
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    if (step(i) != step(0)) return false;
  const auto& loop = specimen.method.options.loop;
  return !loop || times.size() < 2 || *loop->period - (times.back() - times.front()) == step(0);
}

std::optional<double> given(const Method& method, std::string_view parameter) {
  const auto found = method.options.parameters.find(parameter);
  return found == method.options.parameters.end() ? std::nullopt : std::optional(found->second.front());
}

/// A family states what it is by the first word of each choice.
bool is_as_declared(const Specimen& specimen) {
  return std::ranges::all_of(specimen.family.choices, [&](const Choice& choice) {
    const auto word = specimen.method.options.choices.find(choice.name);
    return word == specimen.method.options.choices.end() || word->second == choice.words.front();
  });
}

/// Tensions of zero stop the motion at a key, parameters named here are jumps by their meaning, and the degree or order
/// decides on the continuity.
int declared_continuity(const Specimen& specimen) {
  const auto& [family, method, fuzzed, keys, curve] = specimen;
  if (!is_as_declared(specimen)) return 0;
  int declared = are_even(specimen) ? family.continuity_uniform : family.continuity_uneven;
  if (method.options.parameters.empty()) return declared;
  declared = std::min(declared, family.key_use.smoothest_with_parameters);
  if (const auto order = given(method, "order")) declared = std::min(declared, static_cast<int>(*order));
  if (const auto degree = given(method, "degree")) declared = static_cast<int>(*degree) - 1;
  const bool jumps = given(method, "beta1") || given(method, "continuity");
  return jumps ? 0 : declared;
}

/// Curves of slerps whose handles are wound round are none of their order; see overwound_tangent().
bool is_overwound(const Specimen& specimen) {
  const auto turn = overwound_tangent(specimen.method, specimen.keys);
  return turn && turn->has_value();
}

}  // namespace

void claim_finite(const Specimen& specimen) {
  const AnyCurve& curve = specimen.curve.orientation;
  for (const double t : times_around(curve.knots())) {
    for (const Side side : {Side::left, Side::right}) {
      const Motion m = curve.motion(t, side);
      claim(is_finite(m), "the motion at t = {} is not finite", t);
      claim(std::abs(m.orientation.norm() - 1.0) <= tolerance::algebra, "the norm at t = {} is {}", t,
            m.orientation.norm());
    }
    claim(curve(t).coeffs().allFinite(), "the orientation at t = {} is not finite", t);
    if (!specimen.curve.position) continue;
    const LinearMotion m = specimen.curve.position->linear_motion(t);
    claim(m.position.allFinite() && m.velocity.allFinite() && m.acceleration.allFinite() && m.jerk.allFinite(),
          "the position at t = {} is not finite", t);
  }
}

void claim_through_keys(const Specimen& specimen) {
  const AnyCurve& curve = specimen.curve.orientation;
  if (!is_as_declared(specimen)) return;
  for (std::size_t i = 0; i < specimen.keys.size(); ++i) {
    const double t = specimen.keys.times()[i];
    if (!specimen.family.passes_through(i) || !curve.domain().contains(t)) continue;
    const double off = (curve(t).coeffs() - specimen.keys.orientations()[i].coeffs()).norm();
    claim(off <= tolerance::series, "key {} at t = {} is missed by {}", i, t, off);
  }
}

void claim_continuity(const Specimen& specimen) {
  const AnyCurve& curve = specimen.curve.orientation;
  const int declared = is_overwound(specimen) ? 0 : std::min(3, declared_continuity(specimen));
  const double rounding = specimen.family.is_global() ? tolerance::continuity : closed_form_rounding;
  for (std::size_t i = 1; i < curve.knots().segments(); ++i) {
    const double t = curve.knots().times()[i];
    const SegmentScale left = scale_of(curve, i - 1), right = scale_of(curve, i);
    const auto jumps = difference(curve.motion(t, Side::left), curve.motion(t, Side::right));
    for (int k = 0; k <= declared; ++k) {
      const double jump = jumps[static_cast<std::size_t>(k)], allowed = rounding * scale_at_knot(left, right, k);
      claim(jump <= allowed, "order {} jumps by {} at knot {} at t = {}, allowed {}", k, jump, i, t, allowed);
    }
  }
}

}  // namespace orispline::fuzz
