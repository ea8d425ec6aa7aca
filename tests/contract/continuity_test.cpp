// SPDX-License-Identifier: Apache-2.0
// Contract: a curve is as smooth in time as its family declares, and not one order smoother.
#include <contract/family_contract.hpp>
#include <contract/random_parameters.hpp>
#include <support/relative_jumps.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

template <std::size_t Orders>
void expect_continuous_to_exactly(int order, const std::array<double, Orders>& jumps) {
  for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k)
    EXPECT_LE(jumps[k], tolerance::continuity) << "order " << k << " jumps";
  const std::size_t next = static_cast<std::size_t>(order) + 1;
  if (next < Orders) {
    EXPECT_GE(jumps[next], tolerance::visible_jump) << "order " << next << " does not jump: smoother than declared";
  }
}

/// Steps on uneven times [rad]: with spacing ratios of 10 the handles of a squad are some five times as long, and a
/// handle longer than a full turn has no logarithm of its own any more.
constexpr double moderate_step = 0.8;

template <class F>
std::size_t keys_for(std::size_t segments) {
  return F::info.key_use.keys_for(segments);
}

template <class F>
class Continuity : public testing::Test {};
TYPED_TEST_SUITE(Continuity, FamilyTypes, FamilyNames);

TYPED_TEST(Continuity, IsTheDeclaredOrderOnEvenTimes) {
  for (const std::uint64_t seed : {51u, 52u, 53u}) {
    SCOPED_TRACE(seed);
    const Keyframes keys = keyframes(random_walk(seed, keys_for<TypeParam>(8), Spacing::even));
    expect_continuous_to_exactly(TypeParam::info.continuity_uniform, relative_jumps(typed_curve<TypeParam>(keys)));
  }
}

TYPED_TEST(Continuity, IsTheDeclaredOrderOnTimesWithSpacingRatiosOfTen) {
  for (const std::uint64_t seed : {54u, 55u, 56u}) {
    SCOPED_TRACE(seed);
    const Keyframes keys = keyframes(random_walk(seed, keys_for<TypeParam>(9), Spacing::uneven, moderate_step));
    expect_continuous_to_exactly(TypeParam::info.continuity_uneven, relative_jumps(typed_curve<TypeParam>(keys)));
  }
}

TYPED_TEST(Continuity, HoldsForRandomParametersAtEveryKey) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const Keyframes keys = keyframes(random_walk(57, keys_for<TypeParam>(8), spacing, moderate_step));
    const FamilyInfo& info = TypeParam::info;
    const int declared = spacing == Spacing::even ? info.continuity_uniform : info.continuity_uneven;
    expect_continuous_to_exactly(
        std::min(declared, info.key_use.smoothest_with_parameters),
        relative_jumps(typed_curve<TypeParam>(keys, random_parameters(info, keys.size(), 58))));
  }
}

TYPED_TEST(Continuity, HoldsForEveryEndRule) {
  const Keyframes keys = keyframes(random_walk(59, keys_for<TypeParam>(5), Spacing::uneven, moderate_step));
  for (const EndRule rule : TypeParam::info.ends) {
    End end{.rule = rule};
    if (rule == EndRule::clamped) end.angular_velocity = {0.3, -0.2, 0.1};
    const auto jumps = relative_jumps(typed_curve<TypeParam>(keys, {.start = end, .end = end}));
    for (int k = 0; k <= TypeParam::info.continuity_uneven; ++k)
      EXPECT_LE(jumps[static_cast<std::size_t>(k)], tolerance::continuity) << name_of(rule) << ", order " << k;
  }
}

/// The same promise as a user sees it: no jump of ω, α or jerk between the two sides of a knot.
class MotionContinuity : public FamilyContract {};

TEST_P(MotionContinuity, OfBodyRatesIsTheDeclaredOrder) {
  const AnyCurve c = curve(keyframes(walk(60, 9, Spacing::uneven, moderate_step)));
  std::array<double, 3> jumps{}, sizes{};
  for (std::size_t i = 1; i < c.knots().segments(); ++i) {
    const double t = c.knots().times()[i];
    const Motion left = c.motion(t, Side::left), right = c.motion(t, Side::right);
    const auto gather = [&](std::size_t k, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      jumps[k] = std::max(jumps[k], (a - b).norm());
      sizes[k] = std::max({sizes[k], a.norm(), b.norm()});
    };
    gather(0, left.angular_velocity, right.angular_velocity);
    gather(1, left.angular_acceleration, right.angular_acceleration);
    gather(2, left.angular_jerk, right.angular_jerk);
  }
  const auto order = static_cast<std::size_t>(GetParam().continuity_uneven);
  for (std::size_t k = 0; k < std::min<std::size_t>(order, 3); ++k)
    EXPECT_LE(jumps[k], tolerance::continuity * sizes[k]) << "order " << k + 1;
  if (order < 3) {
    EXPECT_GE(jumps[order], tolerance::visible_jump * sizes[order]) << "order " << order + 1;
  }
}

ORISPLINE_FOR_EVERY_FAMILY(MotionContinuity);

}}  // namespace orispline::contract
