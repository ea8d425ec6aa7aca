// SPDX-License-Identifier: Apache-2.0
// Keys for which the reference's own solvers found no curve: tests/data/golden/not_converged.csv.
#include <gtest/gtest.h>

#include <support/golden_case.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Of the equations at the keys: what a solver that claims success must have reached.
constexpr double largest_residual = 1e-12;

/// What jumps between the two sides of a knot, order by order, relative to its size.
std::array<double, 3> jumps_at(const AnyCurve& curve, double t) {
  const Motion left = curve.motion(t, Side::left), right = curve.motion(t, Side::right);
  return {relative_error(left.orientation, right.orientation),
          relative_error(left.angular_velocity, right.angular_velocity),
          relative_error(left.angular_acceleration, right.angular_acceleration)};
}

void expect_solved(const AnyCurve& curve, const Keyframes& keys, int continuity) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_LE(relative_error(curve(keys.times()[i]), keys.orientations()[i]), largest_residual) << "key " << i;
    const auto jumps = jumps_at(curve, keys.times()[i]);
    for (std::size_t order = 0; order <= static_cast<std::size_t>(continuity); ++order)
      EXPECT_LE(jumps.at(order), tolerance::continuity) << "key " << i << ", order " << order;
  }
}

void expect_refused_or_solved(const std::string& family, int continuity, std::size_t cases) {
  const DataTable keys("golden/keys.csv"), all_cases("golden/not_converged.csv");
  const auto rows = all_cases.rows_where("family", family);
  ASSERT_EQ(rows.size(), cases);
  for (const auto& row : rows) {
    SCOPED_TRACE(label_of(row));
    const Keyframes key_frames = keys_of(keys, row);
    const auto curve = make_curve({family, options_of(row)}, key_frames);
    if (curve) expect_solved(*curve, key_frames, continuity);
    else EXPECT_EQ(curve.error().code, ErrorCode::not_converged) << describe(curve.error());
  }
}

TEST(NotConverged, AKeySetWithoutAKnownNuSplineIsRefusedOrSolvedInEarnest) { expect_refused_or_solved("nu", 1, 1); }

TEST(NotConverged, KeySetsWithoutAKnownInterpolatingBSplineAreRefusedOrSolvedInEarnest) {
  expect_refused_or_solved("bspline-through", 2, 9);
}

TEST(NotConverged, EveryCaseOfTheTableIsOneOfThese) { EXPECT_EQ(DataTable("golden/not_converged.csv").size(), 10u); }

}}  // namespace orispline
