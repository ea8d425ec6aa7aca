// SPDX-License-Identifier: Apache-2.0
// The cumulative B-spline of degree 2…5: Cox–de Boor by its definition, continuity on uneven knots, ends, refusals.
#include <gtest/gtest.h>

#include <orispline/curve/bspline_basis.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

PoseCurve bspline(const Keyframes& keys, std::size_t degree) {
  return make_pose_curve({"bspline", {.parameters = {{"degree", {static_cast<double>(degree)}}}}}, keys).value();
}

/// N_{i,d}(t) by the recursion of Cox and de Boor, as every textbook has it; half-open spans.
double cox_de_boor(std::span<const double> knots, std::size_t i, std::size_t d, double t) {
  if (d == 0) return knots[i] <= t && t < knots[i + 1] ? 1.0 : 0.0;
  return (t - knots[i]) / (knots[i + d] - knots[i]) * cox_de_boor(knots, i, d - 1, t) +
         (knots[i + d + 1] - t) / (knots[i + d + 1] - knots[i + 1]) * cox_de_boor(knots, i + 1, d - 1, t);
}

template <class Degree>
class BSplineDegree : public testing::Test {};
using Degrees = testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>,
                               std::integral_constant<std::size_t, 4>, std::integral_constant<std::size_t, 5>>;
TYPED_TEST_SUITE(BSplineDegree, Degrees);

TYPED_TEST(BSplineDegree, BlendsByTheTailsOfCoxDeBoor) {
  constexpr std::size_t degree = TypeParam::value;
  const std::vector<double> t = random_walk(351, 7, Spacing::uneven).times;
  const Knots spans = bspline_spans<degree>(t);
  // One knot more in front, so that function i of the list belongs to control point i of span 0.
  std::vector<double> knots = bspline_knots<degree>(t);
  knots.insert(knots.begin(), knots.front() - 1.0);
  const BSplineBasis<degree> basis{bspline_knots<degree>(t)};
  for (std::size_t s = 0; s < spans.segments(); ++s)
    for (const double u : {0.0, 0.3, 0.9}) {
      const double time = spans.span(s).start() + u * spans.span(s).step();
      const auto tails = basis(spans.span(s), time);
      double tail = 0.0;
      for (std::size_t k = degree; k >= 1; --k) {
        tail += cox_de_boor(knots, s + k, degree, time);
        EXPECT_NEAR(tails[k - 1], tail, tolerance::algebra) << "span " << s << ", tail " << k;
      }
      EXPECT_NEAR(tail + cox_de_boor(knots, s, degree, time), 1.0, tolerance::algebra);
    }
}

TYPED_TEST(BSplineDegree, IsTheCurveOfItsDefinition) {
  constexpr std::size_t degree = TypeParam::value;
  for (const std::size_t count : {2u, 3u, 4u, 9u}) {
    const Keyframes keys = keyframes(posed_walk(352, count, Spacing::uneven, 1.5));
    const PoseCurve found = bspline(keys, degree);
    const AnyCurve curve(bspline_curve<degree>(keys));
    const AnyPath path(bspline_curve<degree, Eigen::Vector3d>(keys));
    for (const double t : sample_times(curve.knots().times())) {
      EXPECT_TRUE(near(found.orientation.motion(t), curve.motion(t),
                       {tolerance::algebra, tolerance::rates, tolerance::rates, tolerance::rates}))
          << count << " keys";
      EXPECT_TRUE(near(found.position->linear_motion(t).position, path.linear_motion(t).position, tolerance::algebra));
    }
  }
}

TYPED_TEST(BSplineDegree, IsExactlyAsSmoothInTimeOnUnevenKnots) {
  constexpr std::size_t degree = TypeParam::value;
  for (const std::uint64_t seed : {353u, 354u, 355u}) {
    const auto jumps = relative_jumps<7>(bspline_curve<degree>(keyframes(random_walk(seed, 9, Spacing::uneven))));
    for (std::size_t k = 0; k < degree; ++k) EXPECT_LE(jumps[k], tolerance::continuity) << "order " << k;
    EXPECT_GE(jumps[degree], tolerance::visible_jump);
  }
}

TYPED_TEST(BSplineDegree, IsOfItsDegreeInSpace) {
  constexpr std::size_t degree = TypeParam::value;
  const auto path = bspline_curve<degree, Eigen::Vector3d>(keyframes(posed_walk(356, 6, Spacing::uneven, 1.5)));
  using J = Jet<double, static_cast<int>(degree) + 1>;
  for (std::size_t s = 0; s < path.knots().segments(); ++s) {
    const KnotSpan span = path.knots().span(s);
    const auto x = path.point(J::variable(span.start() + 0.4 * span.step()), s).x();
    EXPECT_NEAR(x.c[degree + 1] * std::pow(span.step(), degree + 1), 0.0, tolerance::rates);
    EXPECT_GT(std::abs(x.c[degree]), tolerance::visible_jump);
  }
}

TYPED_TEST(BSplineDegree, RunsFromTheFirstKeyTimeToTheLast) {
  constexpr std::size_t degree = TypeParam::value;
  const Keyframes keys = keyframes(random_walk(357, 6, Spacing::uneven));
  const AnyCurve c = bspline(keys, degree).orientation;
  EXPECT_EQ(c.domain().start, keys.times().front());
  EXPECT_EQ(c.domain().end, keys.times().back());
  EXPECT_EQ(c.knots().segments(), degree % 2 == 0 ? 6u : 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const double inner_knot = degree % 2 == 0 ? 0.5 * (keys.times()[i] + keys.times()[i + 1]) : keys.times()[i + 1];
    EXPECT_EQ(c.knots().times()[i + 1], inner_knot);
  }
}

TYPED_TEST(BSplineDegree, StartsAndEndsAtItsEndKeysOnEvenTimes) {
  const Keyframes keys = keyframes(posed_walk(358, 6, Spacing::even, 1.5));
  const PoseCurve pose = bspline(keys, TypeParam::value);
  for (const std::size_t i : {std::size_t{0}, keys.size() - 1}) {
    EXPECT_TRUE(near(pose.orientation(keys.times()[i]), keys.orientations()[i], tolerance::algebra));
    EXPECT_TRUE(near(pose.position->linear_motion(keys.times()[i]).position, keys.positions()[i], tolerance::algebra));
  }
}

TYPED_TEST(BSplineDegree, RestsWhereAllKeysAreOne) {
  const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.4, -1.0, 2.0));
  KeyframeData data = random_walk(359, 6, Spacing::uneven);
  data.orientations.assign(6, q);
  data.positions.assign(6, Eigen::Vector3d(1, 2, 3));
  const PoseCurve pose = bspline(keyframes(data), TypeParam::value);
  for (const double t : sample_times(pose.orientation.knots().times())) {
    EXPECT_TRUE(near(pose.orientation(t), q, tolerance::exact));
    EXPECT_TRUE(near(pose.position->linear_motion(t).position, data.positions[0], tolerance::exact));
  }
}

TEST(BSpline, EndOnUnevenTimesIsOffByTheUnevennessOfItsWeights) {
  // Degree 3: control points p_1⁻, p_0, p_1 with weights 1/6 and N_1 = h_0/(2(2h_0 + h_1)); equal for h_0 = h_1 only.
  const Keyframes keys = keyframes(random_walk(360, 6, Spacing::uneven));
  const double h0 = keys.times()[1] - keys.times()[0], h1 = keys.times()[2] - keys.times()[1];
  const Eigen::Vector3d step = increment<double>(keys.orientations()[0], keys.orientations()[1]);
  const double off = h0 / (2.0 * (2.0 * h0 + h1)) - 1.0 / 6.0;
  EXPECT_TRUE(near(bspline(keys, 3).orientation(keys.times()[0]), keys.orientations()[0] * exp<double>(off * step),
                   tolerance::algebra));
}

TEST(BSpline, OnEvenTimesHasTheUniformCubicBlendingFunctions) {
  const std::vector<double> t{0.0, 1.0, 2.0, 3.0};
  const BSplineBasis<3> basis{bspline_knots<3>(t)};
  const Knots spans(t);
  for (const double u : {0.0, 0.3, 0.8}) {
    const auto tails = basis(spans.span(1), 1.0 + u);
    EXPECT_NEAR(tails[0], (5.0 + 3.0 * u - 3.0 * u * u + u * u * u) / 6.0, tolerance::algebra);
    EXPECT_NEAR(tails[1], (1.0 + 3.0 * u + 3.0 * u * u - 2.0 * u * u * u) / 6.0, tolerance::algebra);
    EXPECT_NEAR(tails[2], u * u * u / 6.0, tolerance::algebra);
  }
}

TEST(BSpline, HasNoAngularAccelerationAtItsEndsOnEvenTimes) {
  // Reflected control points: the curve is odd about its end key.
  const Keyframes keys = keyframes(random_walk(361, 6, Spacing::even));
  const AnyCurve c = bspline(keys, 3).orientation;
  for (const double t : {keys.times().front(), keys.times().back()})
    EXPECT_TRUE(near(c.motion(t).angular_acceleration, Eigen::Vector3d::Zero(), tolerance::series));
}

TEST(BSpline, RefusesADegreeThatItHasNot) {
  const Keyframes keys = keyframes(random_walk(362, 4, Spacing::even));
  const auto message = [&](double degree) {
    const auto c = make_curve({"bspline", {.parameters = {{"degree", {degree}}}}}, keys);
    return c ? std::string() : c.error().message;
  };
  EXPECT_EQ(message(3.5), "bspline: degree is 3.5, wanted a whole number");
  EXPECT_EQ(message(1.0), "bspline: degree is 1, wanted 2 to 5");
  EXPECT_EQ(message(6.0), "bspline: degree is 6, wanted 2 to 5");
  for (const double degree : {2.0, 3.0, 4.0, 5.0}) EXPECT_EQ(message(degree), "");
}

}}  // namespace orispline
