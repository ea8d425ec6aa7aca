// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/overturned_span.hpp>

#include <algorithm>
#include <numbers>
#include <string>

#include <orispline/base/formatted.hpp>
#include <orispline/families/span_curve.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double worth_saying = 0.25 * std::numbers::pi;  // of a span, beside the turn of its keys [rad]
constexpr double much_farther = 2.0;                      // than the keys
constexpr double of_no_use = 200.0 * std::numbers::pi;  // whatever a curve is for: a hundred full turns of a span [rad]
/// A span whose neighbour's rate would turn it so many times as far may turn farther; the curve tells.
constexpr double suspicious = 3.0;
constexpr int steps = 256;               // of a span, for how far the curve turns
constexpr int chords = 16;               // of a span, for whether that is worth to know
constexpr double far_too_little = 0.75;  // of what is worth saying, by those

/// About how far a curve turns in a span [rad], by chords.
double rough_turn(const SpanCurve& span) {
  double turn = 0.0;
  Eigen::Quaterniond before = span.at(0.0);
  for (int i = 1; i <= chords; ++i) {
    const Eigen::Quaterniond here = span.at(static_cast<double>(i) / chords);
    turn += angular_distance(before, here);
    before = here;
  }
  return turn;
}

/// What is worth saying of a span whose keys turn so far [rad].
double least_turn(double of_keys) { return std::max(much_farther * of_keys, of_keys + worth_saying); }

/// How far the curve of the keys around a span turns there [rad]; 0 where there is none.
double turn_of_curve(const Method& method, const Keyframes& keys, std::size_t span) {
  const auto found = span_of(method, keys, span);
  if (!found) return 0.0;
  const KnotSpan knots = found->curve.knots().span(found->segment);
  double turn = 0.0;
  for (int i = 0; i < steps; ++i)
    turn += found->curve.motion_on(found->segment, knots.start() + (i + 0.5) / steps * knots.step())
                .angular_velocity.norm();
  return turn / steps * knots.step();
}

/// In words: how far the curve turns, and what cures it.
std::string said(const SuspiciousSpan& span, const Method& method, double turn, double of_keys, const Track& track) {
  const auto time = [&](std::size_t key) { return track.time_text(track.time_of(key)); };
  const std::string where = between_keys(track, span.start);
  const std::string cause = formatted(
      "the keys at {} and {} are too near in time for how far they turn; correct the time of one of them, "
      "leave one out, or take",
      time(span.fast), time(span.fast + 1));
  if (turn > of_no_use)
    return formatted(
        "{} cannot be used on these keys: {} its curve goes {:.4g} times all round, where the keys turn "
        "by {:.4g} degrees, since {} slerp or squad, which can be used whatever the times are",
        method.name, where, turn / (2.0 * std::numbers::pi), of_keys * degrees, cause);
  return formatted(
      "{} the curve of {} turns by {:.4g} degrees, where the keys turn by {:.4g}: {} monotone, which "
      "stays near its keys",
      where, method.name, turn * degrees, of_keys * degrees, cause);
}

}  // namespace

std::optional<Warning> overturned_span(const Method& method, const FamilyInfo& family, const Track& track,
                                       const AnyCurve* made) {
  const Keyframes& keys = track.keys;
  if (!family.interpolates || family.key_use.stride > 1 || keys.size() < 3) return std::nullopt;
  std::optional<SuspiciousSpan> found;
  double farthest = 0.0, of_keys = 0.0;
  for (const SuspiciousSpan& span : suspicious_spans(keys, worth_saying, suspicious)) {
    const double own = increment<double>(keys.orientations()[span.start], keys.orientations()[span.start + 1]).norm();
    if (made && made->knots().segments() + 1 >= keys.size()) {
      const auto here = span_of(*made, keys, span.start);
      if (!here || rough_turn(*here) <= far_too_little * least_turn(own)) continue;
    }
    const double turn = turn_of_curve(method, keys, span.start);
    if (turn <= least_turn(own) || turn - own <= farthest - of_keys) continue;
    found = span;
    farthest = turn;
    of_keys = own;
  }
  if (!found) return std::nullopt;
  return Warning{.code = "overturned_span",
                 .message = said(*found, method, farthest, of_keys, track),
                 .where = {.key = found->fast},
                 .numbers = {{"turn_deg", farthest * degrees}, {"turn_of_keys_deg", of_keys * degrees}}};
}

}}  // namespace orispline
