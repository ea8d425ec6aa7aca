// SPDX-License-Identifier: Apache-2.0
// Tan, Xing, Fan & Hong 2018: end derivatives (corrected), tension, knots, the repeated end.
#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/pure_quaternion.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::Quintic;
using Jet5 = Jet<double, 5>;

const std::vector<double> quintic_tensions{0.55, 0.66, 0.41, 0.36, 0.63, 0.6};

AnyCurve quintic(const Keyframes& keys) {
  return make_curve({"quintic", {.parameters = {{"tension", quintic_tensions}}}}, keys).value();
}

/// The three blending functions of segment 0 over unit knots, as jets at u.
std::array<Jet5, 3> quintic_blending(double left, double right, double u) {
  const Knots unit({0.0, 1.0});
  return Quintic::Basis{PerKey({left, right})}(unit.span(0), Jet5::variable(u));
}

TEST(Quintic, BlendingFunctionsHaveTheEndValuesOfTheLemma) {
  const double a = 0.37, b = 0.81;
  const auto start = quintic_blending(a, b, 0.0), end = quintic_blending(a, b, 1.0);
  const auto expect = [](const Jet5& found, double value, double first, double second) {
    EXPECT_NEAR(found.derivative(0), value, tolerance::algebra);
    EXPECT_NEAR(found.derivative(1), first, tolerance::algebra);
    EXPECT_NEAR(found.derivative(2), second, tolerance::algebra);
  };
  expect(start[0], 1, a, -a);
  expect(start[1], 0, a, a);
  expect(start[2], 0, 0, 0);
  expect(end[0], 1, 0, 0);
  expect(end[1], 1, b, -b);
  expect(end[2], 0, b, b);
}

TEST(Quintic, BlendingFunctionsHaveTheLeadingCoefficientsOfDegreeFive) {
  const double a = 0.37, b = 0.81;
  const auto c = quintic_blending(a, b, 0.4);
  EXPECT_NEAR(c[0].c[5], -2.5 * a, tolerance::series);
  EXPECT_NEAR(c[1].c[5], 6.0 - 3.5 * (a + b), tolerance::series);
  EXPECT_NEAR(c[2].c[5], -2.5 * b, tolerance::series);
}

TEST(Quintic, EndDerivativesAreEquations311To313Corrected) {
  // With A = log(Q_{i-1}⁻¹Q_i), B = log(Q_i⁻¹Q_{i+1}): q' = α Q(A + B), q'' = α Q{α(A² + 2AB + B²) + B - A}.
  const KeyframeData data = random_walk(101, 6, Spacing::even);
  const Keyframes keys = keyframes(data);
  const double h = 0.5;
  const auto curve = typed_curve<Quintic>(keys, {.parameters = {{"tension", quintic_tensions}}});
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const AnyQuaternion q = keys.orientations()[i];
    const AnyQuaternion a = half_log(keys.orientations()[i - 1], keys.orientations()[i]);
    const AnyQuaternion b = half_log(keys.orientations()[i], keys.orientations()[i + 1]);
    const double alpha = quintic_tensions[i];
    const AnyQuaternion first = alpha * (q * (a + b));
    const AnyQuaternion second = alpha * (q * (alpha * (a * a + 2.0 * (a * b) + b * b) + (b - a)));
    for (const std::size_t segment : {i - 1, i}) {
      const auto found = quaternion_derivatives(curve, keys.times()[i], segment);
      EXPECT_TRUE(near(h * found[1], first.coeffs(), tolerance::series)) << "key " << i;
      EXPECT_TRUE(near(h * h * found[2], second.coeffs(), tolerance::series)) << "key " << i;
    }
  }
}

TEST(Quintic, RatesAtAKeyAreTheStatedOnes) {
  const Keyframes keys = keyframes(random_walk(102, 6, Spacing::even));
  const AnyCurve curve = quintic(keys);
  const double h = 0.5;
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const Eigen::Vector3d a = increment<double>(keys.orientations()[i - 1], keys.orientations()[i]);
    const Eigen::Vector3d b = increment<double>(keys.orientations()[i], keys.orientations()[i + 1]);
    const double alpha = quintic_tensions[i];
    const Motion m = curve.motion(keys.times()[i]);
    EXPECT_TRUE(near(m.angular_velocity, alpha * (a + b) / h, tolerance::series));
    EXPECT_TRUE(
        near(m.angular_acceleration, (alpha * (b - a) + alpha * alpha * a.cross(b)) / (h * h), tolerance::series));
  }
}

TEST(Quintic, RatesJumpByTheRatioOfTheStepsAtUnevenKnots) {
  const Keyframes keys = keyframes(random_walk(103, 6, Spacing::uneven));
  const AnyCurve curve = quintic(keys);
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = keys.times()[i] - keys.times()[i - 1], after = keys.times()[i + 1] - keys.times()[i];
    const Motion left = curve.motion(keys.times()[i], Side::left), right = curve.motion(keys.times()[i], Side::right);
    EXPECT_TRUE(near(right.angular_velocity * after, left.angular_velocity * before, tolerance::series));
    EXPECT_TRUE(near(right.angular_acceleration * (after * after), left.angular_acceleration * (before * before),
                     tolerance::series));
  }
}

TEST(Quintic, ZeroTensionStopsTheMotionAtTheKey) {
  std::vector<double> stop = quintic_tensions;
  stop[2] = 0.0;
  const Keyframes keys = keyframes(random_walk(104, 6, Spacing::even));
  const Motion m = make_curve({"quintic", {.parameters = {{"tension", stop}}}}, keys)->motion(keys.times()[2]);
  EXPECT_TRUE(near(m.angular_velocity, Eigen::Vector3d::Zero(), tolerance::algebra));
  EXPECT_TRUE(near(m.angular_acceleration, Eigen::Vector3d::Zero(), tolerance::series));
}

TEST(Quintic, NegativeTensionRunsBackThroughTheKey) {
  const Keyframes keys = keyframes(steady_rotation({0, 1, 2, 3}, {0.5, 0, 0}));
  const Motion m = make_curve({"quintic", {.parameters = {{"tension", {-0.3}}}}}, keys)->motion(1.0);
  EXPECT_TRUE(near(m.angular_velocity, Eigen::Vector3d(-0.3, 0, 0), tolerance::series));
}

TEST(Quintic, RepeatedEndKeyHalvesTheEndRate) {
  const Keyframes keys = keyframes(random_walk(105, 6, Spacing::even));
  const AnyCurve curve = quintic(keys);
  const double h = 0.5;
  const Eigen::Vector3d b = increment<double>(keys.orientations()[0], keys.orientations()[1]);
  const Motion first = curve.motion(keys.times().front());
  EXPECT_TRUE(near(first.angular_velocity, quintic_tensions[0] * b / h, tolerance::series));
  EXPECT_TRUE(near(first.angular_acceleration, quintic_tensions[0] * b / (h * h), tolerance::series));

  const Eigen::Vector3d a = increment<double>(keys.orientations()[4], keys.orientations()[5]);
  const Motion last = curve.motion(keys.times().back());
  EXPECT_TRUE(near(last.angular_velocity, quintic_tensions[5] * a / h, tolerance::series));
  EXPECT_TRUE(near(last.angular_acceleration, -quintic_tensions[5] * a / (h * h), tolerance::series));
}

TEST(Quintic, IsNotTheSameRunBackwards) {
  // Nobody states it: the cumulative form depends on the direction of time. A symmetric implementation would be another
  // curve.
  KeyframeData data = random_walk(106, 5, Spacing::even, 2.0);
  const Keyframes keys = keyframes(data);
  std::ranges::reverse(data.orientations);
  const AnyCurve forward = make_curve("quintic", keys).value(),
                 backward = make_curve("quintic", keyframes(data)).value();
  const double sum = keys.times().front() + keys.times().back();
  double largest = 0.0;
  for (const double t : sample_times(keys.times()))
    largest = std::max(largest, angular_distance(forward(t), backward(sum - t)));
  EXPECT_GT(largest, tolerance::visible_jump);
}

}}  // namespace orispline
