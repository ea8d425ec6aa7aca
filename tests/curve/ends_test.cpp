// SPDX-License-Identifier: Apache-2.0
// Ghost keys: what stands before the first key and after the last.
#include <gtest/gtest.h>

#include <orispline/curve/control_points.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Keys whose displacement from the end key is x(distance), a polynomial.
EndNeighbourhood polynomial_neighbourhood(double linear, double quadratic, double cubic) {
  const auto distance = [](std::size_t j) { return std::array{0.0, 0.5, 0.8, 2.0}.at(j); };
  return {.distance = distance, .displacement = [=](std::size_t j) -> Eigen::Vector3d {
            const double d = distance(j);
            return (linear * d + quadratic * d * d + cubic * d * d * d) * Eigen::Vector3d(1, -2, 0.5);
          }};
}

Eigen::Vector3d ghost(EndRule rule, const EndNeighbourhood& end) {
  return ghost_increment(rule, Eigen::Vector3d::Zero(), {1.0, 1.0}, end).value();
}

TEST(Ghost, RepeatedEndHasNoIncrement) {
  EXPECT_EQ(ghost(EndRule::repeat, polynomial_neighbourhood(1, 2, 3)), Eigen::Vector3d::Zero());
}

TEST(Ghost, NaturalEndContinuesTheFirstIncrement) {
  const EndNeighbourhood end = polynomial_neighbourhood(1, 2, 3);
  EXPECT_EQ(ghost(EndRule::natural, end), end.displacement(1));
}

TEST(Ghost, QuadraticEndExtrapolatesAParabolaExactly) {
  const double x = -0.5;  // the ghost mirrors the first distance; the increment leads from it to the end key
  const Eigen::Vector3d wanted = -(1.0 * x + 2.0 * x * x) * Eigen::Vector3d(1, -2, 0.5);
  EXPECT_TRUE(near(ghost(EndRule::quadratic, polynomial_neighbourhood(1, 2, 0)), wanted, tolerance::algebra));
}

TEST(Ghost, CubicEndExtrapolatesACubicExactly) {
  const double x = -0.5;
  const Eigen::Vector3d wanted = -(1.0 * x + 2.0 * x * x + 3.0 * x * x * x) * Eigen::Vector3d(1, -2, 0.5);
  EXPECT_TRUE(near(ghost(EndRule::cubic, polynomial_neighbourhood(1, 2, 3)), wanted, tolerance::algebra));
}

TEST(Ghost, ClampedEndSolvesForTheGivenRate) {
  const EndNeighbourhood end = polynomial_neighbourhood(1, 0, 0);
  const Eigen::Vector3d rate(0.3, 0.1, -0.7);
  for (const RateWeights weights :
       {RateWeights{.before = 0.8, .after = 1.7}, RateWeights{.before = -0.8, .after = -1.7}}) {
    const Eigen::Vector3d before = ghost_increment(EndRule::clamped, rate, weights, end).value();
    EXPECT_TRUE(near(weights.before * before + weights.after * end.displacement(1), rate, tolerance::algebra));
  }
}

TEST(Ghost, ClampedEndWithoutTensionIsAnErrorUnlessAlreadyMet) {
  const EndNeighbourhood end = polynomial_neighbourhood(1, 0, 0);
  const auto impossible = ghost_increment(EndRule::clamped, Eigen::Vector3d(1, 0, 0), {0.0, 0.0}, end);
  ASSERT_FALSE(impossible);
  EXPECT_EQ(impossible.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(impossible.error().message, "a clamped end needs a non-zero tension at that key, found 0");
  EXPECT_TRUE(ghost_increment(EndRule::rest, Eigen::Vector3d::Zero(), {0.0, 0.0}, end));
}

TEST(Ghost, ErrorReachesTheCallerFromEitherEnd) {
  const Keyframes keys = keyframes(random_walk(231, 4, Spacing::even));
  const End clamped{.rule = EndRule::clamped, .angular_velocity = {1, 0, 0}};
  for (const char* family : {"timed-c2", "quintic"}) {
    const auto start = make_curve({family, {.parameters = {{"tension", {0, 1, 1, 1}}}, .start = clamped}}, keys);
    ASSERT_FALSE(start);
    EXPECT_EQ(start.error().message, "a clamped end needs a non-zero tension at that key, found 0");
    EXPECT_FALSE(make_curve({family, {.parameters = {{"tension", {1, 1, 1, 0}}}, .end = clamped}}, keys));
  }
}

TEST(Ghost, MirrorsWithTime) {
  // A curve run backwards has its end rules exchanged: about one axis the product commutes and the curve is the same.
  KeyframeData data{.times = {0.0, 0.4, 1.0, 1.9, 2.4}};
  for (const double angle : {0.0, 0.5, 0.3, 1.2, 1.0})
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0, angle, 0)));
  KeyframeData reversed;
  for (std::size_t i = 5; i-- > 0;) {
    reversed.times.push_back(2.4 - data.times[i]);
    reversed.orientations.push_back(data.orientations[i]);
  }
  for (const EndRule rule :
       {EndRule::repeat, EndRule::natural, EndRule::quadratic, EndRule::cubic, EndRule::clamped, EndRule::rest}) {
    const Eigen::Vector3d rate(0, rule == EndRule::clamped ? 0.7 : 0.0, 0);
    const AnyCurve forward =
        make_curve({"timed-c3", {.start = {rule, rate}, .end = {.rule = EndRule::natural}}}, keyframes(data)).value();
    const AnyCurve backward =
        make_curve({"timed-c3", {.start = {.rule = EndRule::natural}, .end = {rule, -rate}}}, keyframes(reversed))
            .value();
    for (const double t : sample_times(data.times, 4))
      EXPECT_TRUE(near(backward(2.4 - t), forward(t), tolerance::series)) << name_of(rule) << " at " << t;
  }
}

TEST(Ghost, PolygonHoldsItsIncrementsEvenBeyondAFullTurn) {
  const Keyframes keys = keyframes(random_walk(232, 4, Spacing::even));
  FamilySettings settings;
  settings.start = settings.end = {.rule = EndRule::clamped, .angular_velocity = {40.0, 0, 0}};

  const ControlPolygon<> polygon = ghosted_polygon<Eigen::Quaterniond>(keys, settings, {1, 1}, {1, 1}).value();

  ASSERT_EQ(polygon.bases.size(), 3u);
  ASSERT_EQ(polygon.increments.size(), 5u);
  EXPECT_GT(polygon.increments[0].norm(), 2 * pi);
  for (std::size_t i = 0; i < 3; ++i)  // segment i starts from the key before it, or the ghost
    EXPECT_TRUE(near(polygon.bases[i] * exp<double>(polygon.increments[i]), keys.orientations()[i], tolerance::series));
}

}}  // namespace orispline
