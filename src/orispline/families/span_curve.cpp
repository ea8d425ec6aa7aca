// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/span_curve.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/stretched_curve.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t keys_near = 2;       // so many spans away a fast step shapes the curve
constexpr std::size_t keys_around = 16;    // those of the curve that is made, on either side
constexpr std::size_t most_looked_at = 8;  // spans

/// No less than the angle of a step [rad], and at most π/2 times it: without an arc cosine.
double turn_at_most(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double cosine = a.dot(b);
  if (cosine < 0.0) return 2.0 * std::numbers::pi;
  return std::numbers::pi * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

}  // namespace

std::vector<SuspiciousSpan> suspicious_spans(const Keyframes& keys, double turn, double least) {
  const auto t = keys.times();
  const auto q = keys.orientations();
  const std::size_t spans = keys.size() - 1;
  std::vector<double> turns(spans);
  for (std::size_t i = 0; i < spans; ++i) turns[i] = turn_at_most(q[i], q[i + 1]);
  std::vector<SuspiciousSpan> worst;
  for (std::size_t i = 0; i < spans; ++i) {
    SuspiciousSpan span{i, i, 0.0};
    for (std::size_t k = i - std::min(i, keys_near); k <= i + keys_near && k < spans; ++k) {
      const double ratio = turns[k] / (t[k + 1] - t[k]) * (t[i + 1] - t[i]) / (turns[i] + turn);
      if (k != i && ratio > span.ratio) span.ratio = ratio, span.fast = k;
    }
    if (span.ratio > least) worst.push_back(span);
  }
  const std::size_t kept = std::min(worst.size(), most_looked_at);
  std::ranges::partial_sort(worst, worst.begin() + static_cast<std::ptrdiff_t>(kept), std::greater{},
                            &SuspiciousSpan::ratio);
  worst.resize(kept);
  return worst;
}

std::optional<SpanCurve> span_of(const AnyCurve& made, const Keyframes& keys, std::size_t span) {
  if (made.knots().segments() + 1 < keys.size() || is_gap(made, span)) return std::nullopt;
  return SpanCurve{made, span};
}

std::optional<SpanCurve> span_of(const Method& method, const Keyframes& keys, std::size_t span) {
  const std::size_t first = span - std::min(span, keys_around), last = std::min(keys.size(), span + 2 + keys_around);
  std::vector<std::size_t> indices(last - first);
  std::iota(indices.begin(), indices.end(), first);
  Method around = method.at(indices, keys.size());
  around.options.loop.reset();
  auto curve = make_curve(around, keys.at(indices));
  if (!curve || curve->knots().times().size() != indices.size()) return std::nullopt;
  return SpanCurve{*std::move(curve), span - first};
}

std::string between_keys(const Track& track, std::size_t span) {
  const auto time = [&](std::size_t key) { return track.time_text(track.time_of(key)); };
  return formatted("between the keys at {} and {}", time(span), time(span + 1));
}

}}  // namespace orispline
