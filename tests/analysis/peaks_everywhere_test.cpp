// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/analysis/segment_motions.hpp>
#include <orispline/families/registry.hpp>
#include <support/random_motion.hpp>

#include "families/own_blending.hpp"

// Peaks beside 10⁴ samples a segment, half of which crowd to its ends.

namespace orispline { namespace {

constexpr int samples = 10000;

/// Of each method: at night as many as are stated, else fewer of those whose motion takes long to evaluate.
int curves_of_method(bool has_bounds) {
  const char* stated = std::getenv("ORISPLINE_PEAK_CURVES");
  return stated ? std::atoi(stated) : has_bounds ? 20 : 2;
}

/// In [0, 1]: even places, and places down to 1e-9 from either end.
double place(int i) {
  constexpr int half = samples / 2;
  if (i < half) return static_cast<double>(i) / (half - 1);
  const double beside = std::pow(10.0, -9.0 * ((i - half) / 2) / (half / 2 - 1)) / 2.0;
  return i % 2 == 0 ? beside : 1.0 - beside;
}

struct Sampled {
  double rate = 0.0, acceleration = 0.0;
  double time_of_rate = 0.0, time_of_acceleration = 0.0;

  void see(double t, const Motion& m) {
    if (const double size = m.angular_velocity.norm(); size > rate) rate = size, time_of_rate = t;
    if (const double size = m.angular_acceleration.norm(); size > acceleration)
      acceleration = size, time_of_acceleration = t;
  }
};

Sampled densely_sampled(const AnyCurve& curve) {
  Sampled found;
  for (std::size_t s = 0; s < curve.knots().segments(); ++s) {
    const KnotSpan span = curve.knots().span(s);
    SegmentMotions motions(curve, s, MotionPart::rates);
    if (motions.is_gap()) continue;
    std::vector<double> times;
    for (int i = 0; i < samples; ++i) times.push_back(std::lerp(span.start(), span.end(), place(i)));
    for (std::size_t first = 0; first < times.size(); first += SegmentMotions::most) {
      const auto together = std::span(times).subspan(first, std::min(SegmentMotions::most, times.size() - first));
      motions.evaluate(together);
      for (std::size_t i = 0; i < together.size(); ++i) found.see(together[i], motions.rates(i));
    }
  }
  return found;
}

bool has_no_bounds(const SegmentForm& form) {
  return std::holds_alternative<std::monostate>(form) || std::holds_alternative<SquadForm>(form);
}

/// Curves that may turn so far [rad] have bounds that hold, but so many maxima that they are not near, and without
/// bounds not all are found.
constexpr double tight_turn = 1e4;

/// `rounding`: what is none of the motion, infinite where nothing is near.
void expect_largest(const Peak& peak, double sampled, double time, double rounding, const std::string& what) {
  if (!peak.bound && std::isinf(rounding)) return;
  EXPECT_GE(peak.value, sampled * (1.0 - (peak.bound ? 1e-3 : 1e-6)))
      << what << " at " << time << ": " << (1.0 - peak.value / sampled);
  if (!peak.bound) return;
  EXPECT_GE(*peak.bound, sampled) << what << " at " << time;
  EXPECT_LE(*peak.bound, 1.001 * peak.value + rounding) << what << ": " << (*peak.bound / peak.value - 1.0);
}

/// The `i`-th of so many curves of a method: open, or the loop that every fourth one is where it can be. Errors: those
/// of make_curve().
Expected<AnyCurve> curve_of(Method method, int i, int count) {
  const FamilyInfo& info = *family_of_method(method).value();
  const double ratio = std::pow(10.0, 1.0 + 5.0 * i / std::max(count - 1, 1));
  const std::size_t keys_of_curve = info.name == "bezier" ? 7 : 5;  // three control points a segment
  const Keyframes keys = random_keys(static_cast<unsigned>(i) + 100, {keys_of_curve, i % 3 == 0 ? 3.0 : 1.5, ratio});
  if (info.closes && i % 4 == 3) method.options.loop = Loop{keys.times().back() - keys.times().front() + 1.0};
  return make_curve(method, keys);
}

void expect_largest_of(const AnyCurve& curve, const std::string& what) {
  const Peaks found = peaks(curve);
  EXPECT_FALSE(has_no_bounds(curve.form(0)) && found.angular_velocity.bound) << what;
  const Sampled sampled = densely_sampled(curve);
  const auto times = curve.knots().times();
  const bool is_tight = sampled.rate * (times.back() - times.front()) < tight_turn;
  constexpr double any = std::numeric_limits<double>::infinity();
  expect_largest(found.angular_velocity, sampled.rate, sampled.time_of_rate, is_tight ? 1e-8 : any, what + ", rate");
  expect_largest(found.angular_acceleration, sampled.acceleration, sampled.time_of_acceleration,
                 is_tight ? 1e-8 + 1e-12 * sampled.rate * sampled.rate : any, what + ", acceleration");
}

void expect_largest_of(const Method& method) {
  const int count = curves_of_method(!has_no_bounds(curve_of(method, 0, 20).value().form(0)));
  int seen = 0;
  for (int i = 0; i < count; ++i)
    if (const auto curve = curve_of(method, i, count)) {
      ++seen;
      expect_largest_of(*curve, method.name + " " + std::to_string(i));
    }
  EXPECT_GT(seen, 0) << method.name;
}

class PeaksEverywhere : public testing::TestWithParam<FamilyInfo> {};

INSTANTIATE_TEST_SUITE_P(Methods, PeaksEverywhere, testing::ValuesIn(families_info()), [](const auto& test) {
  std::string name(test.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(PeaksEverywhere, AreNotBelowAnySampleHoweverUnevenTheKeys) { expect_largest_of(Method(GetParam())); }

TEST(OwnPeaksEverywhere, AreNotBelowAnySampleOfOwnBlendingFunctions) {
  const std::vector<BlendingData> all{
      {.name = "of-lengths",
       .title = "With the lengths of the segments",
       .parameters = {{.name = "a", .initial = 0.5}},
       .rows = {{"1", "1+2*a*h^2/(5*h_1*(h_1+h))", "1", "1", "1"},
                {"0", "2*a*h_1/(5*(h_1+h))", "1/2", "1-2*a*h1/(5*(h+h1))", "1"},
                {"0", "0", "0", "-2*a*h^2/(5*h1*(h+h1))", "0"}}},
      {.name = "overshooting",
       .title = "Far beyond the keys and back",
       .rows = {{"1", "9/8", "1", "1", "1"}, {"0", "-3", "1/2", "4", "1"}, {"0", "0", "0", "-1/8", "0"}}},
      {.name = "two-keys", .title = "From key to key", .rows = {{"0", "0", "0", "1", "1", "1"}}},
  };
  for (const BlendingData& data : all) expect_largest_of(Method(testing_support::family_of(data)));
}

}}  // namespace orispline
