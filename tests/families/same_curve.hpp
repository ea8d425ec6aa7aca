// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/curve.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline::testing_support {

/// Of two constructions of one curve.
inline constexpr MotionTolerance same_curve{tolerance::algebra, tolerance::series, tolerance::rates, tolerance::rates};

inline void expect_same(const AnyCurve& a, const AnyCurve& b) {
  for (const double t : sample_times(a.knots().times(), 7))
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(a.motion(t, side), b.motion(t, side), same_curve)) << t;
}

}  // namespace orispline::testing_support
