// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/clock_search.hpp>

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/curve/track.hpp>
#include <orispline/families/registry.hpp>

#include "two_recordings.hpp"

namespace orispline { namespace {

using testing_support::Difference;
using testing_support::fixed_recording;
using testing_support::moved_recording;

AnyCurve curve_through(const Track& track) { return make_curve("slerp", track.keys).value(); }

/// Recordings that begin and end apart, on clocks that count from anywhere.
TEST(ClockSearch, NamesTheTrueOffsetFirst) {
  std::mt19937_64 random(3);
  for (const double late : {0.0, -47.0, 47.0, 1.7e6}) {
    const AnyCurve fixed = curve_through(fixed_recording({.from = 100.0, .to = 130.0}, random));
    const AnyCurve moved = curve_through(moved_recording({.from = 104.0, .to = 133.0}, {.offset = late}, random));
    const std::vector<double> offsets = offsets_in_question(moved, fixed, 0.02);
    ASSERT_FALSE(offsets.empty()) << late;
    EXPECT_NEAR(offsets.front(), late, 0.02) << late;
  }
}

}}  // namespace orispline
