// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/overturned_span.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/curve.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double worth_saying = 0.25 * std::numbers::pi;  // of a span, beside the turn of its keys [rad]
constexpr double much_farther = 2.0;                      // than the keys
constexpr double of_no_use = 200.0 * std::numbers::pi;  // whatever a curve is for: a hundred full turns of a span [rad]
/// A span whose neighbour's rate would turn it so many times as far may turn farther; the curve tells.
constexpr double suspicious = 3.0;
constexpr std::size_t keys_near = 2;       // so many spans away a fast step shapes the curve
constexpr std::size_t keys_around = 16;    // those of the curve that is made, on either side
constexpr std::size_t most_looked_at = 8;  // spans
constexpr int steps = 256;                 // of a span, for how far the curve turns
constexpr int chords = 16;                 // of a span, for whether that is worth to know
constexpr double far_too_little = 0.75;    // of what is worth saying, by those

struct Span {
  std::size_t start, fast;  ///< the keys that it and the fast step beside it begin with
  double ratio;             ///< of how far it would turn at that rate to how far its keys turn
};

/// No less than the angle of a step [rad], and at most π/2 times it: without an arc cosine.
double turn_at_most(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double cosine = a.dot(b);
  if (cosine < 0.0) return 2.0 * std::numbers::pi;
  return std::numbers::pi * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

/// The worst first.
std::vector<Span> suspicious_spans(const Keyframes& keys) {
  const auto t = keys.times();
  const auto q = keys.orientations();
  const std::size_t spans = keys.size() - 1;
  std::vector<double> turns(spans);
  for (std::size_t i = 0; i < spans; ++i) turns[i] = turn_at_most(q[i], q[i + 1]);
  std::vector<Span> worst;
  for (std::size_t i = 0; i < spans; ++i) {
    Span span{i, i, 0.0};
    for (std::size_t k = i - std::min(i, keys_near); k <= i + keys_near && k < spans; ++k) {
      const double ratio = turns[k] / (t[k + 1] - t[k]) * (t[i + 1] - t[i]) / (turns[i] + worth_saying);
      if (k != i && ratio > span.ratio) span.ratio = ratio, span.fast = k;
    }
    if (span.ratio > suspicious) worst.push_back(span);
  }
  const std::size_t kept = std::min(worst.size(), most_looked_at);
  std::ranges::partial_sort(worst, worst.begin() + static_cast<std::ptrdiff_t>(kept), std::greater{}, &Span::ratio);
  worst.resize(kept);
  return worst;
}

/// About how far a curve turns in a segment [rad], by chords.
double rough_turn(const AnyCurve& curve, std::size_t segment) {
  const KnotSpan knots = curve.knots().span(segment);
  double turn = 0.0;
  Eigen::Quaterniond before = curve.orientation_on(segment, knots.start());
  for (int i = 1; i <= chords; ++i) {
    const Eigen::Quaterniond here =
        curve.orientation_on(segment, knots.start() + static_cast<double>(i) / chords * knots.step());
    turn += angular_distance(before, here);
    before = here;
  }
  return turn;
}

/// What is worth saying of a span whose keys turn so far [rad].
double least_turn(double of_keys) { return std::max(much_farther * of_keys, of_keys + worth_saying); }

/// How far the curve of the keys around a span turns there [rad]; 0 where there is none.
double turn_of_curve(const Method& method, const Keyframes& keys, std::size_t span) {
  const std::size_t first = span - std::min(span, keys_around), last = std::min(keys.size(), span + 2 + keys_around);
  std::vector<std::size_t> indices(last - first);
  std::iota(indices.begin(), indices.end(), first);
  Method around = method.at(indices, keys.size());
  around.options.loop.reset();
  const auto curve = make_curve(around, keys.at(indices));
  if (!curve || curve->knots().times().size() != indices.size()) return 0.0;
  const std::size_t segment = span - first;
  const KnotSpan knots = curve->knots().span(segment);
  double turn = 0.0;
  for (int i = 0; i < steps; ++i)
    turn += curve->motion_on(segment, knots.start() + (i + 0.5) / steps * knots.step()).angular_velocity.norm();
  return turn / steps * knots.step();
}

/// In words: how far the curve turns, and what cures it.
std::string said(const Span& span, const Method& method, double turn, double of_keys, const Track& track) {
  const auto time = [&](std::size_t key) { return track.time_text(track.time_of(key)); };
  const std::string where = formatted("between the keys at {} and {}", time(span.start), time(span.start + 1));
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
      "{} the curve of {} turns by {:.4g} degrees, where the keys turn by {:.4g}: {} slerp, which turns "
      "no farther than the keys",
      where, method.name, turn * degrees, of_keys * degrees, cause);
}

}  // namespace

std::optional<Warning> overturned_span(const Method& method, const FamilyInfo& family, const Track& track,
                                       const AnyCurve* made) {
  const Keyframes& keys = track.keys;
  if (!family.interpolates || family.key_use.stride > 1 || keys.size() < 3) return std::nullopt;
  std::optional<Span> found;
  double farthest = 0.0, of_keys = 0.0;
  for (const Span& span : suspicious_spans(keys)) {
    const double own = increment<double>(keys.orientations()[span.start], keys.orientations()[span.start + 1]).norm();
    if (made && made->knots().segments() + 1 >= keys.size() &&
        (is_gap(*made, span.start) || rough_turn(*made, span.start) <= far_too_little * least_turn(own)))
      continue;
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
