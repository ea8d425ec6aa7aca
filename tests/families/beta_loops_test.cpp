// SPDX-License-Identifier: Apache-2.0
// Closed Beta curves: the constraints of their joints hold at the seam as at every key.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/beta_joints.hpp>
#include <support/near.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr std::size_t key_count = 6;

struct ClosedBeta {
  std::string name, form;
  bool is_g2;

  [[nodiscard]] Method method(Parameters betas, double period) const {
    Method method(name, {.parameters = std::move(betas), .loop = Loop{period}});
    if (!form.empty()) method.options.choices["form"] = form;
    return method;
  }
};

/// The rates before and after a joint in the local parameter; joint 0 is the seam.
struct JointRates {
  Eigen::Vector3d before1, after1, before2, after2;
};

JointRates rates_at(const AnyCurve& curve, std::size_t joint) {
  const Knots& knots = curve.knots();
  const std::size_t arriving = (joint + knots.segments() - 1) % knots.segments();
  const double before = knots.span(arriving).step(), after = knots.span(joint).step();
  const Motion a = curve.motion(knots.times()[arriving + 1], Side::left), b = curve.motion(knots.times()[joint]);
  return {before * a.angular_velocity, after * b.angular_velocity, before * before * a.angular_acceleration,
          after * after * b.angular_acceleration};
}

class ClosedBetas : public testing::TestWithParam<ClosedBeta> {};

TEST_P(ClosedBetas, FulfilTheirConstraintsAtEveryKeyAndAtTheSeam) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven})
    for (const std::uint64_t seed : {461u, 462u, 463u}) {
      const KeyframeData walk = random_walk(seed, key_count, spacing, 1.0);
      const Parameters betas = mixed_betas(key_count, seed + 10);
      const double period = walk.times.back() - walk.times.front() + 0.4;
      const AnyCurve curve = make_curve(GetParam().method(betas, period), keyframes(walk)).value();
      ASSERT_EQ(curve.knots().segments(), key_count);
      for (std::size_t joint = 0; joint < key_count; ++joint) {
        const double beta1 = betas.at("beta1")[joint], beta2 = betas.at("beta2")[joint];
        const JointRates j = rates_at(curve, joint);
        EXPECT_LE((j.after1 - beta1 * j.before1).norm(), tolerance::series * j.after1.norm()) << "joint " << joint;
        const double missing = (j.after2 - beta1 * beta1 * j.before2 - beta2 * j.before1).norm() / j.after2.norm();
        if (GetParam().is_g2) {
          EXPECT_LE(missing, 10.0 * tolerance::series) << "joint " << joint;
        } else {
          EXPECT_GT(missing, 1e-5) << "joint " << joint;
        }
      }
    }
}

TEST_P(ClosedBetas, RefusePolesWithTheKeyAndValuesOfGhostKeysWhichTheyLack) {
  const Keyframes keys = keyframes(at_whole_times(random_walk(464, 5, Spacing::even)));
  const auto error_of = [&](std::vector<double> beta2) {
    return make_curve(GetParam().method({{"beta2", std::move(beta2)}}, 5.0), keys).error();
  };
  EXPECT_EQ(error_of({-4, 0, 0, 0, 0}).where.key, 0u);
  EXPECT_EQ(error_of({0, 0, 0, 0, -4}).where.key, 4u);
  EXPECT_EQ(error_of({0, 0, 0, 0, 0, 0, 0}).message,
            GetParam().name + ": found 7 values of beta2, wanted 1 or one per key (5)");
}

INSTANTIATE_TEST_SUITE_P(Method, ClosedBetas,
                         testing::Values(ClosedBeta{"beta", "", false}, ClosedBeta{"beta-through", "", false},
                                         ClosedBeta{"beta-g2", "local", true}, ClosedBeta{"beta-g2", "global", true}),
                         [](const auto& test) {
                           std::string name = test.param.name + test.param.form;
                           std::erase(name, '-');
                           return name;
                         });

TEST(ClosedBetas, ThatApproximateAreTheOpenOnesOfTheKeysGoneRoundAgain) {
  const KeyframeData walk = at_whole_times(random_walk(465, key_count, Spacing::even, 1.0));
  const Parameters betas = mixed_betas(key_count, 466);
  KeyframeData rounds;
  Parameters around;
  for (std::size_t i = 0; i < 3 * key_count; ++i) {
    rounds.times.push_back(static_cast<double>(i) - static_cast<double>(key_count));
    rounds.orientations.push_back(walk.orientations[i % key_count]);
    for (const auto& [name, values] : betas) around[name].push_back(values[i % key_count]);
  }
  for (const char* name : {"beta", "beta-g2"}) {
    const AnyCurve closed =
        make_curve({name, {.parameters = betas, .loop = Loop{static_cast<double>(key_count)}}}, keyframes(walk))
            .value();
    const AnyCurve open = make_curve({name, {.parameters = around}}, keyframes(rounds)).value();
    for (const double t : sample_times(closed.knots().times())) {
      const Motion round = closed.motion(t),
                   wanted = open.motion(t, t < closed.domain().end ? Side::right : Side::left);
      EXPECT_LE(angular_distance(round.orientation, wanted.orientation), tolerance::series) << name << " at " << t;
      EXPECT_TRUE(near(round.angular_acceleration, wanted.angular_acceleration, tolerance::rates))
          << name << " at " << t;
    }
  }
}

}}  // namespace orispline
