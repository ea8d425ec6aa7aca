// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <cstdlib>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <orispline/curve/motion.hpp>
#include <orispline/families/registry.hpp>
#include <support/random_motion.hpp>

// Peaks beside 10⁴ samples a segment, half of which crowd to its ends.

namespace orispline { namespace {

constexpr int samples = 10000;
constexpr std::size_t keys_of_curve = 5;

/// Of each method: few in `make test`, more at night.
int curves_of_method() {
  const char* stated = std::getenv("ORISPLINE_PEAK_CURVES");
  return stated ? std::atoi(stated) : 2;
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
    for (int i = 0; i < samples; ++i) {
      const double t = std::lerp(span.start(), span.end(), place(i));
      found.see(t, curve.motion_on(s, t));
    }
  }
  return found;
}

bool has_no_bounds(const SegmentForm& form) {
  return std::holds_alternative<std::monostate>(form) || std::holds_alternative<SquadForm>(form);
}

/// Curves that turn so far within a segment [rad] have bounds that hold, but so many maxima that they are not near.
constexpr double tight_turn = 1e4;

/// `rounding`: what is none of the motion.
void expect_largest(const Peak& peak, double sampled, double time, double rounding, const std::string& what) {
  EXPECT_GE(peak.value, sampled * (1.0 - (peak.bound ? 1e-3 : 1e-6)))
      << what << " at " << time << ": " << (1.0 - peak.value / sampled);
  if (!peak.bound) return;
  EXPECT_GE(*peak.bound, sampled) << what << " at " << time;
  EXPECT_LE(*peak.bound, 1.001 * peak.value + rounding) << what << ": " << (*peak.bound / peak.value - 1.0);
}

TEST(PeaksEverywhere, AreNotBelowAnySampleOfAnyMethodHoweverUnevenTheKeys) {
  std::size_t seen = 0;
  for (const FamilyInfo& info : families_info())
    for (int i = 0; i < curves_of_method(); ++i) {
      const double ratio = std::pow(10.0, 6.0 * (i + 1) / curves_of_method());
      const auto curve = make_curve(
          info.name, random_keys(static_cast<unsigned>(i) + 100, {keys_of_curve, i % 3 == 0 ? 3.0 : 1.5, ratio}));
      if (!curve) continue;
      ++seen;
      const Peaks found = peaks(*curve);
      EXPECT_FALSE(has_no_bounds(curve->form(0)) && found.angular_velocity.bound) << info.name;
      const Sampled sampled = densely_sampled(*curve);
      const std::string what = std::string(info.name) + " " + std::to_string(i);
      const auto times = curve->knots().times();
      const bool is_tight = sampled.rate * (times.back() - times.front()) < tight_turn;
      constexpr double any = std::numeric_limits<double>::infinity();
      expect_largest(found.angular_velocity, sampled.rate, sampled.time_of_rate, is_tight ? 1e-8 : any,
                     what + ", rate");
      expect_largest(found.angular_acceleration, sampled.acceleration, sampled.time_of_acceleration,
                     is_tight ? 1e-8 + 1e-12 * sampled.rate * sampled.rate : any, what + ", acceleration");
    }
  EXPECT_GT(seen, 50U);
}

}}  // namespace orispline
