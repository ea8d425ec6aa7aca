// SPDX-License-Identifier: Apache-2.0
// Contract: on whatever keys a method gives a curve, that is finite, and it nowhere jumps between two keys.
#include <contract/family_contract.hpp>
#include <support/hostile_keys.hpp>
#include <support/jump_search.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

class JumpContract : public FamilyContract {
 protected:
  /// A method that solves equations over all keys takes its time for many that it does not converge for.
  [[nodiscard]] static RandomKeys affordable(RandomKeys keys) {
    const std::size_t most = GetParam().is_global() ? 6 : 60;
    if (keys.data.times.size() <= most) return keys;
    keys.data.times.resize(most);
    keys.data.orientations.resize(most);
    return keys;
  }

  /// No curve, for which the method says so, is none that jumps.
  [[nodiscard]] static ::testing::AssertionResult is_sound_on(const RandomKeys& keys) {
    const KeyframeData data = as_many_as_taken(GetParam(), affordable(keys));
    const auto made = make_curve(GetParam().name, keyframes(data, Signs::shortest));
    if (made) return JumpSearch(*made)();
    return ::testing::AssertionResult(made.error().code == ErrorCode::not_converged ||
                                      is_wound_too_far(GetParam(), made.error()))
           << describe(made.error());
  }
};

TEST_P(JumpContract, NothingJumpsOnHostileKeys) {
  EXPECT_TRUE(holds("continuity inside segments", [](const HostileKeys& random) { require(is_sound_on(random)); }));
}

/// Keys with a step of a minute beside a short one, about one axis but for what the second one points aside: what
/// curves wind on.
RandomKeys winding_keys(double shorter, double first, double second, double aside) {
  const Eigen::Vector3d axis(0.6, 0.0, 0.8), beside(0.6, aside, 0.8);
  RandomKeys keys{.data = {.times = {0.0, 60.0, 60.0 + shorter, 120.0 + shorter}}};
  Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.1, 0.2, 0.3));
  for (const Eigen::Vector3d& step :
       std::array<Eigen::Vector3d, 4>{Eigen::Vector3d::Zero(), first * axis, second * beside, -0.7 * axis}) {
    q = q * exp<double>(step);
    keys.data.orientations.push_back(q);
  }
  return keys;
}

TEST_P(JumpContract, NothingJumpsWhereACurveWinds) {
  const std::vector<double> few{0.0}, several{0.0, 1e-15, 1e-9, 1e-7, 1e-4};
  for (const double shorter : {1e-3, 10.0})
    for (const double first : {0.0, 1e-16, -2.0})
      for (const double second : {1.0, 3.1})
        for (const double aside : GetParam().is_global() ? few : several)
          EXPECT_TRUE(is_sound_on(winding_keys(shorter, first, second, aside)))
              << shorter << " s, " << first << " and " << second << " rad, aside " << aside;
}

TEST_P(JumpContract, NothingJumpsAtARestWhoseKeysDifferInTheirLastBits) {
  const Eigen::Quaterniond q =
      quaternion_wxyz(0.95505481964979899, 0.090795329299302174, 0.24544143289892026, -0.13923003504145903);
  const Eigen::Quaterniond next =
      quaternion_wxyz(0.9550548196497991, 0.090795329299302188, 0.24544143289892029, -0.13923003504145906);
  const Eigen::Quaterniond home = Eigen::Quaterniond::Identity();
  EXPECT_TRUE(is_sound_on({.data = {.times = {0.0, 1.0, 2.0, 3.0}, .orientations = {home, q, next, home}}}));
}

ORISPLINE_FOR_EVERY_FAMILY(JumpContract);

}}  // namespace orispline::contract
