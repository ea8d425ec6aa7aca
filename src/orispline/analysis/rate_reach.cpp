// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/rate_reach.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of the cubic over a step of this length with these squares and slopes at its ends.
double largest_of_cubic(const RateHeight& a, const RateHeight& b, double step) {
  // p(x) = a + s x + B x² + C x³ for x in [0, 1]; where p' = 0 and p'' < 0, x = s / (√(B² - 3 s C) - B).
  const double start = 2.0 * a.slope * step, end = 2.0 * b.slope * step, rise = b.square - a.square;
  const double bend = 3.0 * rise - 2.0 * start - end, twist = start + end - 2.0 * rise;
  const double ends = std::max(a.square, b.square), root = bend * bend - 3.0 * start * twist;
  if (!(root >= 0.0)) return ends;
  const double x = start / (std::sqrt(root) - bend);
  if (!(x > 0.0 && x < 1.0)) return ends;
  return std::max(ends, a.square + x * (start + x * (bend + x * twist)));
}

/// How far the cubic between the outer two is from what is found in the middle, by its value and by its slope.
double deviation(const RateHeight& a, const RateHeight& middle, const RateHeight& b, double steps) {
  const double value = 0.5 * (a.square + b.square) + 0.25 * steps * (a.slope - b.slope);
  const double slope = 0.75 * (b.square - a.square) / steps - 0.25 * (a.slope + b.slope);
  return std::abs(middle.square - value) + 0.25 * steps * std::abs(middle.slope - slope);
}

}  // namespace

RateReach::RateReach(const SegmentForm& form, const KnotSpan& span, const MomentBounds& moments)
    : form_(form), span_(span), moments_(moments), coarse_(coarse_bounds(form, span.step())) {
  if (!coarse_) return;
  round(coarse_->all.rate, coarse_->rounding);
  if (std::isfinite(coarse_->all.rate)) return;
  refine();
  if (std::isfinite(rounding_[0])) return;
  coarse_.reset();  // of a rational curve that may come near the origin
  hull_.reset();
  rounding_ = {};
}

void RateReach::refine() {
  if (!coarse_) return;
  hull_ = SegmentHull::of(form_, span_.step());
  const HullBounds whole = hull_->on(0.0, 1.0);
  round(whole.rate, hull_->rounding(whole));
}

RateSizes RateReach::bounds(const RateSizes& squares, double jerk_square, double step, const HullBounds& hull) const {
  const double radius = 0.5 * step + std::numeric_limits<double>::epsilon() * std::abs(span_.end());
  const double half = 0.5 * radius * radius;
  HullBounds b = hull;
  b.jerk = std::min(hull.jerk, std::sqrt(jerk_square) + hull.snap * radius);
  b.rate = std::min(hull.rate, std::sqrt(squares[0]) + half * b.jerk) + rounding_[0];
  b.acceleration = std::min(hull.acceleration, std::sqrt(squares[1]) + half * hull.snap) + rounding_[1];
  RateSizes sizes{b.rate, b.acceleration,
                  std::min(moments_.torque(b), std::sqrt(squares[2]) + half * moments_.bend(b) + rounding_[2])};
  for (double& size : sizes)
    if (std::isnan(size)) size = infinite;
  return sizes;
}

std::array<StepReach, steps_of_part> RateReach::of_steps(const RateSamples& samples) const {
  std::array<StepReach, steps_of_part> reach{};
  if (hull_) {
    const auto place = [&](double t) { return std::clamp(span_.normalised(t), 0.0, 1.0); };
    const HullBounds part = hull_->on(place(samples.front().time), place(samples.back().time));
    for (std::size_t i = 0; i < steps_of_part; ++i) {
      const RateSample &a = samples[i], &b = samples[i + 1];
      RateSizes squares{};
      for (std::size_t k = 0; k < 3; ++k) squares[k] = std::max(a.heights[k].square, b.heights[k].square);
      reach[i].sizes = bounds(squares, std::max(a.jerk_square, b.jerk_square), b.time - a.time, part);
    }
    return reach;
  }
  std::array<RateSizes, times_of_part> deviations{};
  for (std::size_t i = 1; i < steps_of_part; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      deviations[i][k] = deviation(samples[i - 1].heights[k], samples[i].heights[k], samples[i + 1].heights[k],
                                   samples[i + 1].time - samples[i - 1].time);
  double square_of_part = 0.0;
  for (const RateSample& sample : samples) square_of_part = std::max(square_of_part, sample.heights[0].square);
  for (std::size_t i = 0; i < steps_of_part; ++i) {
    reach[i].unresolved = std::max(deviations[i][0], deviations[i + 1][0]) / square_of_part;
    reach[i].turn = std::sqrt(std::max(samples[i].heights[0].square, samples[i + 1].heights[0].square)) *
                    (samples[i + 1].time - samples[i].time);
    for (std::size_t k = 0; k < 3; ++k) {
      const RateSample &a = samples[i], &b = samples[i + 1];
      const double square = largest_of_cubic(a.heights[k], b.heights[k], b.time - a.time) +
                            std::max(deviations[i][k], deviations[i + 1][k]);
      reach[i].sizes[k] = square >= 0.0 ? std::sqrt(square) : infinite;
    }
  }
  return reach;
}

StepReach RateReach::of_segment(const RateSamples& samples) const {
  StepReach reach;
  if (!coarse_) {
    for (const StepReach& step : of_steps(samples)) {
      reach.unresolved = std::max(reach.unresolved, step.unresolved);
      reach.turn = std::max(reach.turn, step.turn);
      for (std::size_t k = 0; k < 3; ++k) reach.sizes[k] = std::max(reach.sizes[k], step.sizes[k]);
    }
    return reach;
  }
  RateSizes squares{};
  double jerk_square = 0.0, step = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) squares[k] = std::max(squares[k], samples[i].heights[k].square);
    jerk_square = std::max(jerk_square, samples[i].jerk_square);
    if (i > 0) step = std::max(step, samples[i].time - samples[i - 1].time);
  }
  reach.sizes = bounds(squares, jerk_square, step, coarse_->all);
  return reach;
}

}}  // namespace orispline
