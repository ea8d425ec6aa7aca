// SPDX-License-Identifier: Apache-2.0
// rational: the spline of R⁴ behind it, its ends, its energy, its symmetries, and where there is no curve.
#include <gtest/gtest.h>

#include <orispline/families/families.hpp>
#include <orispline/families/registry.hpp>
#include <support/cubic_spline_by_definition.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/tolerance.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

AnyCurve rational_curve(const KeyframeData& data, const CurveOptions& options = {}) {
  return make_curve({"rational", options}, keyframes(data, Signs::shortest)).value();
}

/// s at the parameter u of a segment, unnormalised, by its Bernstein coefficients.
Eigen::Vector4d spatial(const AnyCurve& curve, std::size_t segment, double u) {
  const SegmentForm any_form = curve.form(segment);
  const auto& form = std::get<RationalForm>(any_form);
  const auto basis = bernstein_basis<3>(u);
  Eigen::Vector4d s = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 4; ++i)
      s[static_cast<Eigen::Index>(k)] += basis[i] * form.components[k].coefficients[i];
  return s;
}

TEST(Rational, IsTheNormalisedCubicThatItStates) {
  const AnyCurve c = rational_curve(random_walk(601, 9, Spacing::uneven, 1.0));
  for (std::size_t i = 0; i < c.knots().segments(); ++i)
    for (const double u : {0.0, 0.3, 0.5, 0.9, 1.0}) {
      const KnotSpan span = c.knots().span(i);
      const Eigen::Quaterniond q(Eigen::Vector4d(spatial(c, i, u).normalized()));
      EXPECT_TRUE(near(c.orientation_on(i, span.start() + u * span.step()), q, tolerance::algebra)) << i << ", " << u;
    }
}

TEST(Rational, StatesItsRatesAsJetsThroughTheCurveHaveThem) {
  const Keyframes keys = keyframes(random_walk(602, 9, Spacing::uneven, 1.0));
  const RationalCurve c =
      families::Rational::curve(keys, settle(families::Rational::info, {}, keys.size()).value()).value();
  for (const double t : sample_times(keys.times(), 7)) {
    const std::size_t i = c.knots().segment_at(t);
    EXPECT_TRUE(near(c.motion(t, i), motion_from_jet(c.point(Jet<double, 3>::variable(t), i)),
                     {tolerance::exact, tolerance::series, tolerance::rates, tolerance::rates}));
  }
}

TEST(Rational, HasTheGivenRatesAtClampedEndsAndStandsStillAtRest) {
  const Eigen::Vector3d first(0.4, -1.2, 0.3), last(-0.7, 0.1, 2.0);
  const KeyframeData data = random_walk(603, 8, Spacing::uneven, 1.0);
  const AnyCurve c = rational_curve(data, {.start = {EndRule::clamped, first}, .end = {EndRule::clamped, last}});
  EXPECT_TRUE(near(c.motion(c.domain().start).angular_velocity, first, tolerance::series));
  EXPECT_TRUE(near(c.motion(c.domain().end).angular_velocity, last, tolerance::series));
  const AnyCurve still = rational_curve(data, {.start = {.rule = EndRule::rest}, .end = {.rule = EndRule::rest}});
  for (const double t : {c.domain().start, c.domain().end}) {
    EXPECT_LE(still.motion(t).angular_velocity.norm(), tolerance::series);
    EXPECT_GE(still.motion(t).angular_acceleration.norm(), 0.1);
  }
}

TEST(Rational, HasNoAccelerationAtNaturalEnds) {
  for (const std::uint64_t seed : {604u, 605u}) {
    const AnyCurve c = rational_curve(random_walk(seed, 8, Spacing::uneven, 1.0));
    for (const double t : {c.domain().start, c.domain().end}) {
      EXPECT_LE(c.motion(t).angular_acceleration.norm(), tolerance::rates);
      EXPECT_GE(c.motion(t).angular_velocity.norm(), 0.1);
    }
  }
}

TEST(Rational, IsTheSameBackwardsInTime) {
  const KeyframeData data = random_walk(606, 10, Spacing::uneven, 1.0);
  EXPECT_LE(largest_distance_from_backwards(rational_curve(data), rational_curve(reversed(data))), tolerance::series);
}

TEST(Rational, OfTwoKeysStaysOnTheirGreatArc) {
  const KeyframeData data = random_walk(607, 2, Spacing::even, 2.5);
  const Eigen::Vector3d arc = increment<double>(data.orientations[0], data.orientations[1]);
  const AnyCurve c = rational_curve(data);
  for (const double t : sample_times(data.times, 7))
    EXPECT_LE(increment<double>(data.orientations[0], c(t)).cross(arc).norm(), tolerance::algebra);
}

TEST(Rational, OnStepsOfUpToHalfATurnAtEvenTimesAlwaysHasACurve) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
    EXPECT_TRUE(make_curve("rational", keyframes(random_walk(seed, 8, Spacing::even, 3.0), Signs::shortest))) << seed;
}

/// Keys of an example of this repository.
KeyframeData example(const std::string& name) {
  const DataTable table("../../examples/data/" + name);
  KeyframeData data;
  for (std::size_t i = 0; i < table.size(); ++i) {
    data.times.push_back(table.row(i).number("t"));
    data.orientations.push_back(table.row(i).quaternion("qw", "qx", "qy", "qz"));
  }
  return data;
}

TEST(Rational, HasTheEnergyOfADenseSolutionWithNumPy) {
  // ∫|α|² dt [rad²/s³] by Gauss's rule of 40 nodes a segment, from a dense solution of the same conditions.
  EXPECT_NEAR(energy(rational_curve(example("five_keys.csv"))), 33.40827723493457, 1e-4);
  EXPECT_NEAR(energy(rational_curve(example("flight_keys.csv"))), 17.644222741135817, 1e-4);
}

Error refusal(const KeyframeData& data, const CurveOptions& options = {}) {
  return make_curve({"rational", options}, keyframes(data, Signs::as_given)).error();
}

TEST(Rational, WithoutACurveNamesTheKeyTheNormAndTheCure) {
  // From key 1 straight through 0 to its negative.
  const Eigen::Quaterniond p = exp<double>(Eigen::Vector3d(0.5, 0.2, 0.1));
  const Eigen::Quaterniond back(-p.coeffs());
  const Error error = refusal({.times = {0.0, 1.0, 2.0, 3.0}, .orientations = {p, p, back, back}});
  EXPECT_EQ(error.code, ErrorCode::not_converged);
  EXPECT_EQ(error.where.key, 1u);
  EXPECT_EQ(error.message,
            "rational has no curve through these keys: on the way to the next key the spline of the quaternions comes "
            "within 0 of 0, wanted 0.001 at least; put keys in between, or take a local method such as auto");
}

TEST(Rational, RefusesExactlyWhereTheSplineComesTooNearToZero) {
  // Turns of nearly 360°, off the plane by an angle more and more: |s| in the middle grows with it.
  std::size_t refused = 0, made = 0;
  for (const double off : {0.0, 1e-4, 1e-3, 3e-3, 1e-2, 0.1, 0.5}) {
    const Eigen::Quaterniond p = Eigen::Quaterniond::Identity();
    const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(2.0 * pi - off, 0.0, 0.0));
    const End rest{.rule = EndRule::rest};  // then |s| is least in the middle: |p + q|/2
    const double least = 0.5 * (p.coeffs() + q.coeffs()).norm();
    const auto c = make_curve({"rational", {.start = rest, .end = rest}},
                              keyframes({.times = {0.0, 1.0}, .orientations = {p, q}}, Signs::as_given));
    EXPECT_EQ(c.has_value(), least >= families::Rational::least_norm) << off;
    ++(c ? made : refused);
    if (!c) continue;
    EXPECT_NEAR(spatial(*c, 0, 0.5).norm(), least, tolerance::algebra);
    EXPECT_TRUE(c->motion(0.5).angular_jerk.allFinite());
  }
  EXPECT_GE(refused, 2u);
  EXPECT_GE(made, 3u);
}

TEST(Rational, CarriesPositionsOnTheCubicSpline) {
  const KeyframeData data = posed_walk(608, 9, Spacing::uneven);
  const PoseCurve pose = make_pose_curve("rational", keyframes(data)).value();
  const CubicSplineByDefinition spline(data.times, data.positions);
  for (const double t : sample_times(data.times))
    EXPECT_TRUE(near(pose.position->linear_motion(t).position,
                     spline.derivative(0, t, pose.orientation.knots().segment_at(t)), tolerance::series));
}

}}  // namespace orispline
