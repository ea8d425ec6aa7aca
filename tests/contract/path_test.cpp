// SPDX-License-Identifier: Apache-2.0
// Contract: a position moves as smoothly as the orientation beside it, over the same times.
#include <contract/family_contract.hpp>
#include <support/typed_curves.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

template <class F>
Keyframes posed_walk(std::uint64_t seed, Spacing spacing) {
  KeyframeData data = random_walk(seed, F::info.key_use.keys_for(8), spacing, step_on(F::info, spacing, 0.8));
  Dice dice(seed + 1);
  for (std::size_t i = 0; i < data.times.size(); ++i) data.positions.push_back(3.0 * dice.vector());
  return keyframes(data);
}

/// Largest jump of the k-th derivative of a path at its inner knots, relative to its largest size there and in the
/// middle of the segments: some families have derivatives that vanish at the knots.
template <Path P>
double relative_jump(const P& path, std::size_t k) {
  const auto derivative = [&path, k](double t, std::size_t segment) -> Eigen::Vector3d {
    const auto p = path.point(Jet<double, 4>::variable(t), segment);
    return {p.x().derivative(k), p.y().derivative(k), p.z().derivative(k)};
  };
  double jump = 0.0, size = 0.0;
  for (std::size_t segment = 1; segment < path.knots().segments(); ++segment) {
    const KnotSpan span = path.knots().span(segment);
    const Eigen::Vector3d left = derivative(span.start(), segment - 1), right = derivative(span.start(), segment);
    jump = std::max(jump, (left - right).norm());
    size = std::max({size, left.norm(), right.norm(), derivative(span.start() + 0.5 * span.step(), segment).norm()});
  }
  return jump / size;
}

template <class F>
class PathContinuity : public testing::Test {};
TYPED_TEST_SUITE(PathContinuity, FamilyTypes, FamilyNames);

TYPED_TEST(PathContinuity, IsAtLeastThatOfTheOrientation) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const int order = spacing == Spacing::even ? TypeParam::info.continuity_uniform : TypeParam::info.continuity_uneven;
    const auto path = typed_path<TypeParam>(posed_walk<TypeParam>(71, spacing));
    for (int k = 0; k <= order; ++k)
      EXPECT_LE(relative_jump(path, static_cast<std::size_t>(k)), tolerance::continuity) << "order " << k;
  }
}

/// That of the positions on uneven times.
int path_continuity(const FamilyInfo& family) {
  if (family.name.starts_with("squad")) return 1;  // Catmull–Rom in time: C1 beside any squad
  if (family.name == "nu") return 2;               // without tension the cubic spline, which on the sphere is C1 only
  return family.continuity_uneven;
}

TYPED_TEST(PathContinuity, IsNoBetterThanItsBlendingFunctions) {
  const auto path = typed_path<TypeParam>(posed_walk<TypeParam>(72, Spacing::uneven));
  const auto next = static_cast<std::size_t>(path_continuity(TypeParam::info)) + 1;
  EXPECT_GE(relative_jump(path, next), tolerance::visible_jump);
}

TYPED_TEST(PathContinuity, IsThatOfThePathThatTheRegistryGives) {
  const Keyframes keys = posed_walk<TypeParam>(73, Spacing::uneven);
  const auto typed = typed_path<TypeParam>(keys);
  const PoseCurve pose = make_pose_curve(TypeParam::info.name, keys).value();
  for (const double t : sample_times(typed.knots().times())) {
    const Eigen::Vector3d wanted = typed.point(t, typed.knots().segment_at(t));
    EXPECT_TRUE(near(pose.position->linear_motion(t).position, wanted, tolerance::algebra)) << t;
  }
  EXPECT_EQ(pose.orientation.domain().start, typed.knots().front());
  EXPECT_EQ(pose.orientation.domain().end, typed.knots().back());
}

}}  // namespace orispline::contract
