// SPDX-License-Identifier: Apache-2.0
// Contract: rest stays rest, and a constant rate is kept exactly where the registry says so and nowhere else.
#include <contract/family_contract.hpp>
#include <support/properties.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

const Eigen::Vector3d rate(0.7, -0.5, 0.9);

class SteadyMotionContract : public FamilyContract {
 protected:
  /// Ends that continue the last increment, where the family has them: repeated end keys would slow any motion down.
  [[nodiscard]] static CurveOptions steady_ends() {
    if (std::ranges::count(GetParam().ends, EndRule::natural) == 0) return {};
    return {.start = {.rule = EndRule::natural}, .end = {.rule = EndRule::natural}};
  }

  /// Largest deviation from ω = rate, α = 0 over the whole curve.
  [[nodiscard]] static double deviation(const std::vector<double>& times) {
    const AnyCurve c = curve(keyframes(steady_rotation(times, rate)), steady_ends());
    double largest = 0.0;
    for (const double t : times_on(c, 7)) {
      const Motion m = c.motion(t);
      largest = std::max({largest, (m.angular_velocity - rate).norm(), m.angular_acceleration.norm()});
    }
    return largest;
  }

  static void expect_kept_as_declared(bool declared, double deviation) {
    if (declared) EXPECT_LE(deviation, tolerance::rates);
    else EXPECT_GE(deviation, tolerance::visible_jump);
  }
};

TEST_P(SteadyMotionContract, EqualKeysGiveRest) {
  const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.4, -1.0, 2.0));
  const KeyframeData data{.times = {0.0, 1.0, 1.1, 2.1, 4.0, 4.5, 5.0}, .orientations = std::vector(7, q)};
  const AnyCurve c = curve(keyframes(data));
  for (const double t : times_on(c))
    EXPECT_TRUE(near(c.motion(t), {.orientation = q},
                     {tolerance::exact, tolerance::algebra, tolerance::algebra, tolerance::rates}));
}

TEST_P(SteadyMotionContract, ConstantRateOnEvenTimesIsKeptAsDeclared) {
  expect_kept_as_declared(GetParam().keeps_constant_rate_uniform, deviation({0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0}));
}

TEST_P(SteadyMotionContract, ConstantRateOnUnevenTimesIsKeptAsDeclared) {
  expect_kept_as_declared(GetParam().keeps_constant_rate_uneven, deviation({0.0, 1.0, 1.1, 2.1, 2.2, 2.9, 3.9}));
}

ORISPLINE_FOR_EVERY_FAMILY(SteadyMotionContract);

}}  // namespace orispline::contract
