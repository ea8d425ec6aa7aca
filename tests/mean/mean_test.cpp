// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include <orispline/mean/descent.hpp>
#include <orispline/mean/only_one.hpp>
#include <orispline/mean/rough_sums.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>

#include "mean/set_of.hpp"

namespace orispline { namespace {

using testing_support::any_orientation;
using testing_support::base_pose;
using testing_support::degree;
using testing_support::near;
using testing_support::normal_vector;
using testing_support::SetOf;
using testing_support::turned;

TEST(Mean, OfTurnsThatCancelIsWhereTheyBegan) {
  const SetOf set = turned(base_pose, {{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 1.5}, {0, 0, -1.5}});
  const auto found = set.mean();
  ASSERT_TRUE(found);
  EXPECT_LT(angular_distance(found->orientation, base_pose), 1e-15);
  EXPECT_NEAR(found->rms_distance, std::sqrt((1.0 + 4.0 + 2.25) / 3.0) * degree, 1e-15);
  EXPECT_NEAR(found->largest_distance, 2.0 * degree, 1e-15);
  EXPECT_EQ(found->count, 6u);
  EXPECT_EQ(found->weight, 6.0);
  const Eigen::Vector3d variances = Eigen::Vector3d(2.0, 8.0, 4.5) / 5.0 * degree * degree;
  EXPECT_LT((found->spread->diagonal() - variances).norm(), 1e-17);
  EXPECT_LT((*sigma_of(*found) - (variances / 6.0).cwiseSqrt()).norm(),
            2e-4 * sigma_of(*found)->norm());  // but for bending
}

TEST(Mean, OfTwoIsOnTheWayBetweenThemByTheirWeights) {
  for (const double angle : {1.0, 60.0, 170.0, 179.9999}) {
    SetOf set = turned(base_pose, {{0, 0, 0}, {0, 0, angle}});
    set.weights = {3.0, 1.0};
    const auto found = set.mean();
    ASSERT_TRUE(found);
    EXPECT_LT(angular_distance(found->orientation, turned(base_pose, {{0, 0, 0.25 * angle}}).orientations[0]), 1e-15);
    EXPECT_NEAR(found->ball_radius, 0.5 * angle * degree, 1e-8);
    EXPECT_TRUE(found->certified);
  }
}

TEST(Mean, DoesNotCareForSignsOrOrder) {
  std::mt19937_64 random(7);
  SetOf set, other;
  for (int k = 0; k < 20; ++k) {
    set.orientations.push_back(base_pose * exp<double>(normal_vector(random, 0.4)));
    set.weights.push_back(1.0 + k % 3);
  }
  for (std::size_t k = set.orientations.size(); k-- > 0;) {
    other.orientations.push_back(set.orientations[k]);
    if (k % 2 == 0) other.orientations.back().coeffs() *= -1.0;
    other.weights.push_back(set.weights[k]);
  }
  for (const auto& kind : {&SetOf::mean, &SetOf::median})
    EXPECT_TRUE(near((set.*kind)()->orientation, (other.*kind)()->orientation, 1e-15));
}

TEST(Mean, TakesAWeightForAsManyRows) {
  std::mt19937_64 random(8);
  SetOf weighted, repeated;
  for (int k = 0; k < 6; ++k) {
    const Eigen::Quaterniond q = base_pose * exp<double>(normal_vector(random, 0.3));
    weighted.orientations.push_back(q);
    weighted.weights.push_back(k);  // the first counts for nothing
    repeated.orientations.insert(repeated.orientations.end(), static_cast<std::size_t>(k), q);
  }
  for (const auto& kind : {&SetOf::mean, &SetOf::median}) {
    const auto found = (weighted.*kind)(), wanted = (repeated.*kind)();
    EXPECT_TRUE(near(found->orientation, wanted->orientation, 1e-15));
    EXPECT_EQ(found->count, 5u);
    EXPECT_EQ(found->weight, 15.0);
    EXPECT_NEAR(found->rms_distance, wanted->rms_distance, 1e-15);
    EXPECT_NE(found->farthest, 0u);
  }
}

TEST(Mean, TurnsWithTheWorldAndWithTheBody) {
  std::mt19937_64 random(9);
  SetOf set, moved;
  const Eigen::Quaterniond world = any_orientation(random), body = any_orientation(random);
  for (int k = 0; k < 30; ++k) {
    set.orientations.push_back(base_pose * exp<double>(normal_vector(random, 0.3)));
    moved.orientations.push_back(world * set.orientations.back() * body);
  }
  for (const auto& kind : {&SetOf::mean, &SetOf::median}) {
    const auto found = (set.*kind)(), there = (moved.*kind)();
    EXPECT_LT(angular_distance(there->orientation, world * found->orientation * body), 2e-15);
    const Eigen::Matrix3d r = body.conjugate().toRotationMatrix();
    EXPECT_LT((*there->covariance - r * *found->covariance * r.transpose()).norm(), 1e-12 * found->covariance->norm());
  }
}

TEST(Mean, HasTheStandardDeviationsOfItsErrors) {
  std::mt19937_64 random(10);
  constexpr std::size_t runs = 400, count = 60;
  const Eigen::Vector3d noise(0.05, 0.15, 0.3);
  for (const auto& kind : {&SetOf::mean, &SetOf::median}) {
    Eigen::Vector3d squares = Eigen::Vector3d::Zero(), variances = Eigen::Vector3d::Zero();
    for (std::size_t run = 0; run < runs; ++run) {
      SetOf set;
      for (std::size_t k = 0; k < count; ++k)
        set.orientations.push_back(base_pose *
                                   exp<double>(Eigen::Vector3d(normal_vector(random, 1.0).cwiseProduct(noise))));
      const auto found = (set.*kind)();
      squares += increment<double>(found->orientation, base_pose.dot(found->orientation) < 0.0
                                                           ? Eigen::Quaterniond(-base_pose.coeffs())
                                                           : base_pose)
                     .cwiseAbs2();
      variances += found->covariance->diagonal();
    }
    const Eigen::Vector3d ratio = squares.cwiseQuotient(variances);  // 1 ± sqrt(2/400) = ± 0.07
    EXPECT_GT(ratio.minCoeff(), 0.75) << ratio.transpose();
    EXPECT_LT(ratio.maxCoeff(), 1.25) << ratio.transpose();
  }
}

TEST(Mean, OfShotsIsTheirBasePose) {
  // What recordings/05_shots.csv holds: turns of 1, 2 and 1.5 degrees both ways about the axes of a base.
  const Eigen::Quaterniond base = Eigen::Quaterniond(0.07042819, -0.17980985, -0.07042819, 0.97864608).normalized();
  const SetOf set = turned(base, {{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 1.5}, {0, 0, -1.5}});
  EXPECT_LT(angular_distance(set.mean()->orientation, base), 1e-15);
  EXPECT_LT(angular_distance(set.median()->orientation, base), 1e-15);
}

TEST(Mean, OfASingleOrientationIsThatOne) {
  for (const auto& kind : {&SetOf::mean, &SetOf::median}) {
    const auto found = (turned(base_pose, {{0, 0, 0}}).*kind)();
    ASSERT_TRUE(found);
    EXPECT_LT(angular_distance(found->orientation, base_pose), 1e-15);
    EXPECT_TRUE(found->certified);
    EXPECT_EQ(found->largest_distance, 0.0);
    EXPECT_FALSE(found->covariance || found->spread || sigma_of(*found));
  }
}

TEST(Mean, OfEqualOrientationsHasNoSpread) {
  for (const auto& kind : {&SetOf::mean, &SetOf::median}) {
    const auto found = (turned(base_pose, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).*kind)();
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->certified);
    EXPECT_LT(found->covariance->norm() + found->spread->norm() + found->largest_distance, 1e-15);
  }
}

TEST(Mean, SaysWhereItMayNotBeTheOnlyOne) {
  // Three of four right angles about an axis: as good is the one in the middle of any two neighbours, or nearly.
  const auto found = turned(base_pose, {{0, 0, 0}, {0, 0, 119}, {0, 0, -119}}).mean();
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->certified);
  EXPECT_FALSE(found->others_within);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_EQ(found->warnings[0].code, "mean_not_certified");
  EXPECT_NE(found->warnings[0].message.find("there may be another that is as good or better"), std::string::npos);
  EXPECT_NEAR(found->warnings[0].number("largest_distance_deg"), 119.0, 1e-9);
}

TEST(Mean, IsProvedTheOnlyOneBeyondABallToo) {
  std::mt19937_64 random(13);
  SetOf set;
  for (int k = 0; k < 300; ++k) set.orientations.push_back(base_pose * exp<double>(normal_vector(random, 0.6)));
  const auto found = set.mean();
  ASSERT_TRUE(found);
  EXPECT_GT(found->ball_radius, std::numbers::pi / 2.0);
  EXPECT_TRUE(found->certified && found->others_within == 0.0 && found->warnings.empty());
  const auto sum_at = [&](const Eigen::Quaterniond& q) {
    double sum = 0.0;
    for (const auto& p : set.orientations) sum += std::pow(angular_distance(q, p), 2);
    return sum;
  };
  const double least = sum_at(found->orientation);
  for (int k = 0; k < 2000; ++k) EXPECT_GT(sum_at(any_orientation(random)), least);
}

TEST(Mean, OfBoundsIsBelowWhatTheyBound) {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> up_to_one(0.0, 1.0);
  for (int run = 0; run < 20000; ++run) {
    const double apart = 3.14 * up_to_one(random), from = 0.01 + 3.1 * up_to_one(random),
                 to = std::min(3.14, from + 0.25 * up_to_one(random)), away = from + (to - from) * up_to_one(random);
    const Eigen::Vector3d v = normal_vector(random, 1.0).normalized(), u = normal_vector(random, 1.0).normalized();
    const double distance =
        angular_distance(exp<double>(Eigen::Vector3d(away * v)), exp<double>(Eigen::Vector3d(apart * u)));
    const double rise = 0.5 * (distance * distance - apart * apart) + away * apart * v.dot(u);
    EXPECT_LE(mean_of::least_rise(mean_of::HalvedAngle(apart), mean_of::HalvedAngle(from), to), rise + 1e-12);
  }
}

TEST(Mean, OfRoughSumsIsNearTheExactOnes) {
  std::mt19937_64 random(15);
  mean_of::Weighted<Eigen::Quaterniond> given;
  for (int k = 0; k < 37; ++k) given.points.push_back(any_orientation(random)), given.weights.push_back(1.0 / 37.0);
  for (const MeanKind kind : {MeanKind::mean, MeanKind::median}) {
    const mean_of::RoughSums rough(kind, given);
    for (int k = 0; k < 100; ++k) {
      const Eigen::Quaterniond q = any_orientation(random);
      const double exact = mean_of::pull_at(kind, given, q).sum;
      EXPECT_NEAR(rough.at(q, exact + 1e-5), exact, 2e-6);
      EXPECT_EQ(rough.at(q, exact - 1e-5), std::numeric_limits<double>::infinity());
    }
  }
}

TEST(Mean, OfChordsIsWhereTheirSquaresAreLeast) {
  std::mt19937_64 random(16);
  SetOf set;
  for (int k = 0; k < 40; ++k) {
    set.orientations.push_back(base_pose * exp<double>(normal_vector(random, 0.7)));
    set.weights.push_back(1.0 + k % 3);
  }
  const auto found = mean(set.view(), {.kind = MeanKind::chordal});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->certified);
  EXPECT_LT(found->residual, 1e-14);
  EXPECT_TRUE(near(found->orientation, *chordal_mean(set.view()), 0.0));
  const auto sum_at = [&](const Eigen::Quaterniond& q) {
    double sum = 0.0;
    for (std::size_t k = 0; k < set.orientations.size(); ++k)
      sum += set.weights[k] * std::pow(std::sin(0.5 * angular_distance(q, set.orientations[k])), 2);
    return sum;
  };
  for (int k = 0; k < 200; ++k)
    EXPECT_LE(sum_at(found->orientation), sum_at(found->orientation * exp<double>(normal_vector(random, 0.01))));
  const auto mean = set.mean();
  EXPECT_LT((*found->spread - *mean->spread).norm(), 0.2 * mean->spread->norm());
  EXPECT_TRUE(found->covariance && found->covariance->diagonal().minCoeff() > 0.0);
  EXPECT_FALSE(chordal_mean(turned(base_pose, {{0, 0, 0}, {0, 0, 180}}).view()));
}

TEST(Mean, IsNoWorseThanAnyOfTheRowsOrWhatLiesBelowThem) {
  const auto sum_at = [](const Eigen::Quaterniond& q, const SetOf& set) {
    double sum = 0.0;
    for (const auto& p : set.orientations) sum += std::pow(angular_distance(q, p), 2);
    return sum;
  };
  std::mt19937_64 random(12);
  for (int run = 0; run < 50; ++run) {
    SetOf set;
    for (int k = 0; k < 5; ++k) set.orientations.push_back(any_orientation(random));
    const auto found = set.mean();
    ASSERT_TRUE(found);
    for (const auto& q : set.orientations) EXPECT_LE(sum_at(found->orientation, set), sum_at(q, set));
  }
}

TEST(Mean, RefusesOrientationsThatCancel) {
  for (const auto& kind : {&SetOf::mean, &SetOf::median}) {
    const auto antipodes = (turned(base_pose, {{0, 0, 0}, {0, 0, 180}}).*kind)();
    ASSERT_FALSE(antipodes);
    EXPECT_EQ(antipodes.error().code, ErrorCode::bad_data);
    EXPECT_TRUE(
        antipodes.error().message.starts_with("found orientations that cancel, such as two that are 180° apart"))
        << antipodes.error().message;
    EXPECT_FALSE((turned(base_pose, {{0, 0, 0}, {0, 0, 120}, {0, 0, 240}}).*kind)());
  }
}

TEST(Mean, SaysWhatIsWrongWithWeightsAndQuaternions) {
  const auto error_with = [](std::vector<double> weights) {
    SetOf set = turned(base_pose, {{0, 0, 0}, {0, 0, 10}});
    set.weights = std::move(weights);
    return describe(set.mean().error());
  };
  EXPECT_EQ(error_with({0, 0}), "found the weight 0 at every orientation, wanted one above 0 at least");
  EXPECT_EQ(error_with({1, -2}), "key 1: found the weight -2, wanted 0 or a number above it");
  EXPECT_EQ(error_with({std::numeric_limits<double>::quiet_NaN(), 1}),
            "key 0: found the weight nan, wanted 0 or a number above it");
  EXPECT_EQ(error_with({1}), "found 1 weight of 2 orientations, wanted one of each");
  EXPECT_EQ(error_with({1e308, 1e308}), "found weights whose sum is not finite, wanted smaller ones");
  EXPECT_EQ(describe(mean({}).error()), "found no orientations, wanted one at least");
  SetOf bent = turned(base_pose, {{0, 0, 0}});
  bent.orientations[0].coeffs() *= 0.9;
  EXPECT_EQ(describe(bent.mean().error()), "key 0: the quaternion has norm 0.9, wanted 1 within 0.001");
  SetOf far = turned(base_pose, {{0, 0, 0}});
  far.positions = {{0, std::numeric_limits<double>::quiet_NaN(), 0}};
  EXPECT_FALSE(far.mean());
}

TEST(Mean, ComesToRestAlsoWhereOrientationsAreAllAround) {
  std::mt19937_64 random(11);
  for (int run = 0; run < 50; ++run) {
    SetOf set;
    for (int k = 0; k < 40; ++k) set.orientations.push_back(any_orientation(random));
    const auto found = set.mean();
    ASSERT_TRUE(found);
    EXPECT_LT(found->residual, 1e-14);
    EXPECT_FALSE(found->certified);
    EXPECT_LT(found->iterations, 60u);
  }
}

}}  // namespace orispline
