// SPDX-License-Identifier: Apache-2.0
// Inner quaternions that the keys of `squad` are given: a_n and b_n of Eberly, section 6.
#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include <families/key_steps.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/geodesic.hpp>
#include <support/data_table.hpp>
#include <support/inner_quaternions.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

KeyframeData inner_walk(std::uint64_t seed, Spacing spacing = Spacing::uneven) {
  return with_inner_quaternions(random_walk(seed, 7, spacing), seed + 1);
}

AnyCurve squad_through(const KeyframeData& data, const CurveOptions& options = {}) {
  return make_curve({"squad", options}, keyframes(data)).value();
}

void expect_same_bits(const KeyframeData& found, const KeyframeData& wanted, const CurveOptions& options = {}) {
  const AnyCurve a = squad_through(found, options), b = squad_through(wanted, options);
  for (const double t : sample_times(wanted.times)) {
    EXPECT_EQ(a(t).coeffs(), b(t).coeffs());
    EXPECT_EQ(a.motion(t).angular_jerk, b.motion(t).angular_jerk);
  }
}

/// Those that (22) gives the keys between the ends.
KeyframeData with_chosen_inner(KeyframeData data) {
  const Keyframes keys = keyframes(data);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == keys.size();
    const Eigen::Vector3d handle =
        is_end ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(-0.25 * (step(keys, i, i + 1) + step(keys, i, i - 1)));
    data.inner_leaving.push_back(keys.orientations()[i] * exp<double>(handle));
  }
  data.inner_arriving = data.inner_leaving;
  return data;
}

TEST(InnerQuaternions, GiveTheMotionOfAnIndependentReference) {
  KeyframeData data;
  const DataTable golden_keys("golden/inner_keys.csv"), golden("golden/inner.csv");
  for (const auto& key : golden_keys.rows()) {
    data.times.push_back(key.number("t"));
    data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
    data.inner_leaving.push_back(key.quaternion("a_qw", "a_qx", "a_qy", "a_qz"));
    data.inner_arriving.push_back(key.quaternion("b_qw", "b_qx", "b_qy", "b_qz"));
  }
  const AnyCurve curve = make_curve("squad", keyframes(data, Signs::shortest)).value();
  for (const auto& row : golden.rows()) {
    const Motion wanted{.orientation = row.quaternion("qw", "qx", "qy", "qz"),
                        .angular_velocity = row.vector("wx", "wy", "wz"),
                        .angular_acceleration = row.vector("ax", "ay", "az"),
                        .angular_jerk = row.vector("jx", "jy", "jz")};
    const Side side = row.text("side") == "left" ? Side::left : Side::right;
    EXPECT_TRUE(near(curve.motion(row.number("t"), side), wanted, tolerance::golden)) << row.number("t");
  }
  EXPECT_EQ(golden.rows().size(), 24u);
}

TEST(InnerQuaternions, AreTheControlPointsOfTheirSegments) {
  for (const std::uint64_t seed : {331u, 332u, 333u, 334u}) {
    const KeyframeData data = inner_walk(seed);
    const AnyCurve curve = squad_through(data);
    for (std::size_t n = 0; n + 1 < data.times.size(); ++n)
      for (const double u : {0.1, 0.5, 0.8}) {
        const double t = data.times[n] + u * (data.times[n + 1] - data.times[n]);
        EXPECT_TRUE(near(curve(t),
                         squad<double>(data.orientations[n], data.inner_leaving[n], data.inner_arriving[n + 1],
                                       data.orientations[n + 1], u),
                         tolerance::algebra));
      }
  }
}

TEST(InnerQuaternions, GiveTheRatesOfEquation20AtTheEndsOfASegment) {
  const KeyframeData data = inner_walk(335);
  const Keyframes keys = keyframes(data);
  const AnyCurve curve = squad_through(data);
  for (std::size_t n = 0; n + 1 < keys.size(); ++n) {
    const double h = data.times[n + 1] - data.times[n];
    const Eigen::Vector3d along = step(keys, n, n + 1),
                          leaving = increment<double>(data.orientations[n], data.inner_leaving[n]),
                          arriving = increment<double>(data.orientations[n + 1], data.inner_arriving[n + 1]);
    EXPECT_TRUE(near(curve.motion(data.times[n], Side::right).angular_velocity, (along + 2.0 * leaving) / h,
                     tolerance::series));
    EXPECT_TRUE(near(curve.motion(data.times[n + 1], Side::left).angular_velocity, (along - 2.0 * arriving) / h,
                     tolerance::series));
  }
}

TEST(InnerQuaternions, ThatTheMethodWouldChooseGiveItsCurve) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const KeyframeData data = random_walk(336, 7, spacing);
    const AnyCurve found = squad_through(with_chosen_inner(data)), wanted = squad_through(data);
    for (const double t : sample_times(data.times)) {
      EXPECT_TRUE(near(found(t), wanted(t), 1e-15));
      EXPECT_TRUE(near(found.motion(t), wanted.motion(t), tolerance::golden));
    }
  }
}

TEST(InnerQuaternions, ThatAreFreeAreChosen) {
  const KeyframeData plain = random_walk(337, 7, Spacing::uneven);
  KeyframeData data = plain;
  data.inner_leaving.assign(7, free_inner());
  expect_same_bits(data, plain);
  data.inner_arriving = data.inner_leaving;
  expect_same_bits(data, plain);
  const KeyframeData given = inner_walk(337);
  data.inner_leaving[3] = given.inner_leaving[3];
  const AnyCurve curve = squad_through(data), without = squad_through(plain);
  for (const double t : sample_times(data.times)) {
    const bool is_other = t > data.times[3] && t < data.times[4];
    EXPECT_EQ(curve(t).coeffs() == without(t).coeffs(), !is_other) << t;
  }
}

TEST(InnerQuaternions, TakeTheSignThatIsNearerToTheirKey) {
  const KeyframeData data = inner_walk(338);
  KeyframeData negated = data;
  for (auto* side : {&negated.inner_leaving, &negated.inner_arriving})
    for (Eigen::Quaterniond& q : *side) q.coeffs() = -q.coeffs();
  expect_same_bits(negated, data);
}

TEST(InnerQuaternions, OutsideTheCurveAreNotUsed) {
  const KeyframeData data = inner_walk(339);
  KeyframeData other = data;
  other.inner_arriving.front() = about_x(1.0);
  other.inner_leaving.back() = free_inner();
  expect_same_bits(other, data);
}

TEST(InnerQuaternions, ChangeSidesWhereTimeRunsBackwards) {
  const KeyframeData data = inner_walk(343);
  KeyframeData back = data;
  for (std::size_t i = 0; i < 7; ++i) back.times[i] = -data.times[6 - i];
  for (auto* list : {&back.orientations, &back.inner_leaving, &back.inner_arriving}) std::ranges::reverse(*list);
  std::swap(back.inner_leaving, back.inner_arriving);
  const AnyCurve curve = squad_through(data), other = squad_through(back);
  for (const double t : sample_times(data.times)) EXPECT_TRUE(near(other(-t), curve(t), tolerance::algebra));
}

TEST(InnerQuaternions, GoBeforeTheEndRules) {
  const End key{.rule = EndRule::key}, phantom{.rule = EndRule::phantom};
  KeyframeData data = inner_walk(340);
  const AnyCurve one = squad_through(data, {.start = key, .end = key}),
                 other = squad_through(data, {.start = phantom, .end = phantom});
  for (const double t : sample_times(data.times)) EXPECT_EQ(one(t).coeffs(), other(t).coeffs());
  data.inner_leaving.front() = free_inner();
  const double h = data.times[1] - data.times[0];
  const Eigen::Vector3d half = step(keyframes(data), 0, 1) / (2.0 * h);
  EXPECT_TRUE(
      near(squad_through(data, {.start = phantom}).motion(data.times[0]).angular_velocity, half, tolerance::series));
}

TEST(InnerQuaternions, AreUsedByTheFamiliesThatSaySo) {
  for (const FamilyInfo& family : families_info()) {
    const KeyframeData plain = random_walk(341, family.key_use.keys_for(4), Spacing::even, 0.6);
    const auto without = make_curve(family.name, keyframes(plain));
    const auto curve = make_curve(family.name, keyframes(with_inner_quaternions(plain, 342)));
    ASSERT_TRUE(without && curve) << family.name;
    const double t = 0.5 * (curve->knots().times()[1] + curve->knots().times()[2]);
    EXPECT_EQ((*curve)(t).coeffs() != (*without)(t).coeffs(), family.takes_inner_quaternions()) << family.name;
  }
  EXPECT_TRUE(find_family("squad").value()->takes_inner_quaternions());
}

}}  // namespace orispline
