// SPDX-License-Identifier: Apache-2.0
// Contract: the rates are the derivatives of the orientation, by differences and by jets of the whole quaternion.
#include <contract/family_contract.hpp>
#include <support/typed_curves.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

class DerivativeContract : public FamilyContract {};

TEST_P(DerivativeContract, RatesAreCentralDifferencesOfTheOrderBelow) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const AnyCurve c = curve(keyframes(walk(41, 7, spacing)));
    for (std::size_t i = 0; i < c.knots().segments(); ++i)
      for (const double u : {0.15, 0.55, 0.85}) {  // not where `least` joins its pieces, whose jerk jumps there
        const KnotSpan span = c.knots().span(i);
        const double h = tolerance::difference_step * span.step(), t = span.start() + u * span.step();
        const Motion before = c.motion(t - h), here = c.motion(t), after = c.motion(t + h);
        EXPECT_TRUE(near(increment<double>(before.orientation, after.orientation) / (2 * h), here.angular_velocity,
                         tolerance::difference));
        EXPECT_TRUE(near((after.angular_velocity - before.angular_velocity) / (2 * h), here.angular_acceleration,
                         tolerance::difference));
        EXPECT_TRUE(near((after.angular_acceleration - before.angular_acceleration) / (2 * h), here.angular_jerk,
                         tolerance::difference));
      }
  }
}

TEST_P(DerivativeContract, WorldRatesAreDifferencesInTheWorldFrame) {
  const double h = tolerance::difference_step;
  const AnyCurve c = curve(keyframes(walk(42, 4, Spacing::even)));
  for (const double u : {0.3, 1.4, 1.7}) {
    const double t = c.domain().start + u;
    const Motion before = c.motion(t - h), here = c.motion(t), after = c.motion(t + h);
    const Eigen::Vector3d turned = log<double>(after.orientation * before.orientation.conjugate());
    EXPECT_TRUE(near(turned / (2 * h), angular_velocity_world(here), tolerance::difference));
    EXPECT_TRUE(near((angular_velocity_world(after) - angular_velocity_world(before)) / (2 * h),
                     angular_acceleration_world(here), tolerance::difference));
    EXPECT_TRUE(near((angular_acceleration_world(after) - angular_acceleration_world(before)) / (2 * h),
                     angular_jerk_world(here), tolerance::difference));
  }
}

ORISPLINE_FOR_EVERY_FAMILY(DerivativeContract);

template <class F>
class JetOracle : public testing::Test {};
TYPED_TEST_SUITE(JetOracle, FamilyTypes, FamilyNames);

TYPED_TEST(JetOracle, EvaluatorAgreesWithJetsOfTheWholeQuaternion) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const FamilyInfo& info = TypeParam::info;
    const Keyframes keys = keyframes(random_walk(43, info.key_use.keys_for(7), spacing, step_on(info, spacing, 2.5)));
    const auto typed = typed_curve<TypeParam>(keys);
    if constexpr (std::same_as<std::remove_cv_t<decltype(typed)>, AnyCurve>) continue;  // differences have to do
    const AnyCurve erased = make_curve(TypeParam::info.name, keys).value();
    for (const double t : sample_times(erased.knots().times(), 7)) {
      const std::size_t segment = erased.knots().segment_at(t);
      const Motion oracle = motion_from_jet(typed.point(Jet<double, 3>::variable(t), segment));
      EXPECT_TRUE(near(erased.motion(t), oracle, same_motion)) << t;
    }
  }
}

}}  // namespace orispline::contract
