// SPDX-License-Identifier: Apache-2.0
// Spherical averages: the equation that defines them, its derivatives, symmetry, interpolation, ends, refusals.
#include <gtest/gtest.h>

#include <orispline/curve/key_knots.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;
using families::Averages;

/// Cox–de Boor by its recursion: function i of the degree over a list of knots.
template <Number T>
T bspline(const std::vector<double>& knots, std::size_t i, std::size_t degree, const T& t, std::size_t span) {
  if (degree == 0) return T(i == span ? 1.0 : 0.0);
  const double* k = knots.data() + i;
  return (t - T(k[0])) / (k[degree] - k[0]) * bspline(knots, i, degree - 1, t, span) +
         (T(k[degree + 1]) - t) / (k[degree + 1] - k[1]) * bspline(knots, i + 1, degree - 1, t, span);
}

/// Key times with three of their mirror images on either side.
std::vector<double> mirrored_knots(std::span<const double> t) {
  std::vector<double> knots(t.begin(), t.end());
  for (std::size_t k = 1; k <= 3; ++k) {
    knots.insert(knots.begin(), 2.0 * t.front() - t[k]);
    knots.push_back(2.0 * t.back() - t[t.size() - 1 - k]);
  }
  return knots;
}

std::vector<Eigen::Quaterniond> with_mirrored_ends(std::span<const Eigen::Quaterniond> q) {
  std::vector<Eigen::Quaterniond> all{q[0] * q[1].conjugate() * q[0]};
  all.insert(all.end(), q.begin(), q.end());
  all.push_back(q.back() * q[q.size() - 2].conjugate() * q.back());
  return all;
}

/// Σ N_k(t) log(q⁻¹ p_k) with every function and every control point, by definition.
template <Number T>
Vector3<T> missing(std::span<const double> times, std::span<const Eigen::Quaterniond> controls, const Quaternion<T>& q,
                   const T& t, std::size_t segment) {
  const std::vector<double> knots = mirrored_knots(times);
  const std::vector<Eigen::Quaterniond> points = with_mirrored_ends(controls);
  Vector3<T> sum = Vector3<T>::Zero();
  for (std::size_t k = segment; k <= segment + 3; ++k)
    sum += increment<T>(q, constant<T>(points[k])) * bspline(knots, k, 3, t, segment + 3);
  return sum;
}

const CurveOptions keys_as_control_points{.choices = {{"points", "control"}}};

/// Σ w_k |log(q⁻¹ p_k)|².
double squares(const AverageCurve& curve, const Eigen::Quaterniond& q, double t) {
  const auto weights = curve.weights(t, 0);
  double sum = 0.0;
  for (std::size_t k = 0; k < AverageCurve::active; ++k)
    sum += weights[k] * increment<double>(q, curve.points()[k]).squaredNorm();
  return sum;
}

TEST(Averages, AreWhereTheSumOfSquaresIsLeastAllAround) {
  // The equation holds at saddles and maxima too, where control points stand all around. Newton's steps lead there from
  // where one point is opposite to the average of the others.
  Dice dice(463);
  const Knots knots = key_knots(keyframes(random_walk(464, 2, Spacing::even)));
  const double start = knots.times()[0], step = knots.times()[1] - start;
  BSplineBasis<3> basis;
  for (int k = -2; k <= 3; ++k) basis.knots.push_back(start + k * step);
  for (int i = 0; i < 3000; ++i) {
    std::vector<Eigen::Quaterniond> points;
    while (points.size() < AverageCurve::active) points.push_back(exp<double>(6.0 * dice.vector()));
    if (i % 2 == 0) {
      const Eigen::Vector3d half = 2.2 * dice.vector().normalized();
      points[0] = Eigen::Quaterniond(-(points[1] * exp<double>(half)).coeffs()) * exp<double>(0.3 * dice.vector());
      points[2] = points[1] * exp<double>(2.0 * half);
    }
    const AverageCurve curve(knots, basis, points);
    const double t = start + step * dice();
    const Eigen::Quaterniond q = curve.point(t, 0);
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    for (std::size_t k = 0; k < AverageCurve::active; ++k) mean += curve.weights(t, 0)[k] * points[k].coeffs();
    const double least = squares(curve, q, t);
    EXPECT_LE(least, squares(curve, Eigen::Quaterniond(mean.normalized()), t) + tolerance::algebra) << i;
    EXPECT_LE(curve.missing(q, curve.weights(t, 0), 0).norm(), tolerance::series) << i;
    for (int axis = 0; axis < 3; ++axis)
      for (const double turn : {-1e-3, 1e-3})
        EXPECT_LE(least, squares(curve, q * exp<double>(turn * Eigen::Vector3d::Unit(axis)), t)) << i;
  }
}

TEST(Averages, SolveTheirEquation) {
  const Keyframes keys = keyframes(random_walk(451, 8, Spacing::uneven));
  const AnyCurve c = make_curve({"averages", keys_as_control_points}, keys).value();
  for (const double t : sample_times(keys.times(), 9)) {
    const std::size_t segment = c.knots().segment_at(t);
    EXPECT_LE(missing<double>(keys.times(), keys.orientations(), c(t), t, segment).norm(), tolerance::algebra) << t;
  }
}

TEST(Averages, SolveTheirEquationWithAllDerivatives) {
  // The implicit function theorem: the equation holds as a power series in time, order by order.
  using J = Jet<double, 4>;
  const Keyframes keys = keyframes(random_walk(452, 8, Spacing::uneven));
  const auto curve = typed_curve<Averages>(keys, keys_as_control_points);
  for (const double t : sample_times(keys.times())) {
    const std::size_t segment = curve.knots().segment_at(t);
    const double h = curve.knots().span(segment).step();
    const auto left =
        missing<J>(keys.times(), keys.orientations(), curve.point(J::variable(t), segment), J::variable(t), segment);
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t order = 0; order <= 4; ++order)
        EXPECT_NEAR(left[axis].c[order] * std::pow(h, order), 0.0, tolerance::series) << "order " << order;
  }
}

TEST(Averages, TurnAtTheRateOfTheImplicitFunctionTheorem) {
  // ω = (Σ N_k J_l⁻¹(φ_k))⁻¹ Σ N'_k φ_k, φ_k = log(q⁻¹ p_k).
  const Keyframes keys = keyframes(random_walk(453, 6, Spacing::uneven));
  const AnyCurve c = make_curve({"averages", keys_as_control_points}, keys).value();
  const std::vector<double> knots = mirrored_knots(keys.times());
  const std::vector<Eigen::Quaterniond> points = with_mirrored_ends(keys.orientations());
  for (const double t : sample_times(keys.times())) {
    const std::size_t segment = c.knots().segment_at(t);
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    Eigen::Vector3d driven = Eigen::Vector3d::Zero();
    for (std::size_t k = segment; k <= segment + 3; ++k) {
      const Eigen::Vector3d phi = increment<double>(c(t), points[k]);
      const auto weight = bspline(knots, k, 3, Jet<double, 1>::variable(t), segment + 3);
      jacobian += weight.c[0] * left_jacobian_inverse<double>(phi);
      driven += weight.c[1] * phi;
    }
    EXPECT_TRUE(near(c.motion(t).angular_velocity, Eigen::Vector3d(jacobian.lu().solve(driven)), tolerance::series));
  }
}

TEST(Averages, OfTwoKeysAreSlerp) {
  for (const CurveOptions& options : {CurveOptions{}, keys_as_control_points}) {
    const Keyframes keys = keyframes(random_walk(454, 2, Spacing::even));
    const AnyCurve c = make_curve({"averages", options}, keys).value(), slerp = make_curve("slerp", keys).value();
    for (const double t : sample_times(keys.times(), 9))
      EXPECT_TRUE(near(c.motion(t), slerp.motion(t),
                       {tolerance::algebra, tolerance::series, tolerance::series, tolerance::rates}));
  }
}

TEST(Averages, DoNotDependOnTheOrderOfTheControlPoints) {
  // Backwards in time the products of a cumulative curve are in another order, the sums of an average are the same.
  const KeyframeData data = random_walk(455, 7, Spacing::uneven);
  KeyframeData backwards = data;
  std::ranges::reverse(backwards.orientations);
  std::ranges::reverse(backwards.times);
  for (double& t : backwards.times) t = -t;
  const auto difference = [&](std::string_view method, const CurveOptions& options) {
    const AnyCurve c = make_curve({method, options}, keyframes(data)).value();
    const AnyCurve d = make_curve({method, options}, keyframes(backwards)).value();
    double largest = 0.0;
    for (const double t : sample_times(data.times)) largest = std::max(largest, angular_distance(c(t), d(-t)));
    return largest;
  };
  EXPECT_LE(difference("averages", keys_as_control_points), tolerance::series);
  EXPECT_GE(difference("bspline", {}), tolerance::visible_jump);
}

TEST(Averages, PassThroughTheKeysByDefaultOnly) {
  const Keyframes keys = keyframes(random_walk(456, 8, Spacing::uneven, 0.8));
  const AnyCurve through = make_curve("averages", keys).value();
  const AnyCurve near_keys = make_curve({"averages", keys_as_control_points}, keys).value();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double t = keys.times()[i];
    EXPECT_TRUE(near(through(t), keys.orientations()[i], tolerance::series)) << i;
    const bool end = i == 0 || i + 1 == keys.size();
    EXPECT_EQ(angular_distance(near_keys(t), keys.orientations()[i]) < tolerance::visible_jump, end) << i;
  }
}

TEST(Averages, BeginAndEndWithoutAcceleration) {
  const Keyframes keys = keyframes(random_walk(457, 6, Spacing::uneven, 0.8));
  for (const CurveOptions& options : {CurveOptions{}, keys_as_control_points}) {
    const AnyCurve c = make_curve({"averages", options}, keys).value();
    EXPECT_LE(c.motion(keys.times().front()).angular_acceleration.norm(), tolerance::rates);
    EXPECT_LE(c.motion(keys.times().back()).angular_acceleration.norm(), tolerance::rates);
  }
}

TEST(Averages, OnOneAxisAreTheSplineOfTheAngle) {
  KeyframeData data = random_walk(458, 7, Spacing::uneven);
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  const std::array angles{0.0, 0.9, 1.0, 1.3, 1.0, 0.6, 0.8};
  for (std::size_t i = 0; i < 7; ++i) {
    data.orientations[i] = exp<double>(angles[i] * axis);
    data.positions.push_back(angles[i] * axis);
  }
  for (const CurveOptions& options : {CurveOptions{}, keys_as_control_points}) {
    const PoseCurve pose = make_pose_curve({"averages", options}, keyframes(data)).value();
    for (const double t : sample_times(data.times))
      EXPECT_LE((log<double>(pose.orientation(t)) - pose.position->linear_motion(t).position).norm(),
                tolerance::series);
  }
}

TEST(Averages, OfPositionsAreTheNaturalCubicSplineFarFromTheOriginToo) {
  for (const double far : {0.0, 6.4e6}) {
    KeyframeData data = random_walk(459, 7, Spacing::uneven, 0.8);
    Dice dice(460);
    for (std::size_t i = 0; i < 7; ++i) data.positions.push_back(dice.vector() + Eigen::Vector3d(far, 0, 0));
    const auto path = typed_path<Averages>(keyframes(data));
    const auto derivative = [&](double t, std::size_t segment, std::size_t k) {
      const auto p = path.point(Jet<double, 2>::variable(t), segment);
      return Eigen::Vector3d(p.x().derivative(k), p.y().derivative(k), p.z().derivative(k));
    };
    const double rounding = 1e-15 * std::max(1.0, far), h2 = 0.01;  // the shortest step squared
    for (std::size_t i = 0; i < 7; ++i) {
      const std::size_t before = i > 0 ? i - 1 : 0, after = std::min<std::size_t>(i, 5);
      for (const std::size_t segment : {before, after}) {
        EXPECT_LE((derivative(data.times[i], segment, 0) - data.positions[i]).norm(), 100.0 * rounding);
        if (i == 0 || i == 6) {
          EXPECT_LE(derivative(data.times[i], segment, 2).norm(), 1000.0 * rounding / h2);
        }
      }
      EXPECT_LE((derivative(data.times[i], before, 2) - derivative(data.times[i], after, 2)).norm(),
                1000.0 * rounding / h2);
    }
  }
}

TEST(Averages, StartFromRestAndComeToRestWhereOneTurnIsMoreThanHalfOfOne) {
  // Control points that stay, turn by 240° the way that the signs say, and stay: not all in one half of the sphere.
  const Eigen::Vector3d turn = 4.0 / 3.0 * pi * Eigen::Vector3d(0.48, -0.6, 0.64);
  KeyframeData data = random_walk(462, 6, Spacing::uneven);
  for (std::size_t i = 0; i < 6; ++i) {
    data.orientations[i] = exp<double>(i < 3 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : turn);
    data.positions.push_back(i < 3 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : turn);
  }
  const auto keys = Keyframes::make(data, Signs::as_given);
  const auto pose = make_pose_curve({"averages", keys_as_control_points}, *keys);
  ASSERT_TRUE(pose) << describe(pose.error());
  const AnyCurve& c = pose->orientation;
  EXPECT_EQ(c.motion(data.times[1]).angular_velocity.norm(), 0.0);
  EXPECT_GT(c.motion(data.times[2]).angular_velocity.norm(), 0.1);
  EXPECT_LE(c.motion(data.times[4]).angular_velocity.norm(), tolerance::rates);
  for (const double t : sample_times(data.times, 9))
    EXPECT_LE((log<double>(c(t)) - pose->position->linear_motion(t).position).norm(), tolerance::series) << t;
}

TEST(Averages, TellWhereTheirEquationsHaveNoSolution) {
  KeyframeData data = random_walk(461, 6, Spacing::even);
  for (std::size_t i = 0; i < 6; ++i)
    data.orientations[i] = exp<double>(i % 2 == 0 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(5.5, 0, 0));
  for (const CurveOptions& options : {CurveOptions{}, keys_as_control_points}) {
    const auto c = make_curve({"averages", options}, keyframes(data));
    if (c) continue;
    EXPECT_EQ(c.error().code, ErrorCode::not_converged);
    EXPECT_LT(c.error().where.key.value(), 6u);
  }
  EXPECT_FALSE(make_curve("averages", keyframes(data)));
}

TEST(Averages, AreRefusedWhereAKeyIsNotTheAverageThoughItFulfilsTheEquation) {
  for (const auto& [seed, count, step] :
       {std::tuple{606u, 5u, 2.5106477622627388}, std::tuple{1032u, 5u, 1.7720811535913819},
        std::tuple{1174u, 7u, 2.4361419526000896}}) {
    const auto c = make_curve("averages", keyframes(random_walk(seed, count, Spacing::uneven, step)));
    ASSERT_FALSE(c) << seed;
    EXPECT_EQ(c.error().code, ErrorCode::not_converged);
    EXPECT_NE(c.error().message.find("are too far apart to have one average"), std::string::npos) << c.error().message;
  }
}

TEST(Averages, OfControlPointsAllAroundAreRefusedRatherThanJump) {
  // Half turns about three axes in turn and back: in between the average would change from one side to the other.
  const KeyframeData data{.times = {0.0, 1.0, 2.5, 3.0, 4.0},
                          .orientations = {quaternion_wxyz(1.0, 0.0, 0.0, 0.0), quaternion_wxyz(0.0, 1.0, 0.0, 0.0),
                                           quaternion_wxyz(0.0, 0.0, 1.0, 0.0), quaternion_wxyz(0.0, 0.0, 0.0, 1.0),
                                           quaternion_wxyz(1.0, 0.0, 0.0, 0.0)}};
  const auto c = make_curve("averages", keyframes(data));
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::not_converged);
  EXPECT_NE(c.error().message.find("are too far apart to have one average"), std::string::npos) << c.error().message;
}

TEST(Averages, TellWhereOneWouldJumpToAnother) {
  const auto keys = Keyframes::make(random_walk(2424, 6, Spacing::uneven, 4.5), Signs::as_given);
  const auto c = make_curve({"averages", keys_as_control_points}, *keys);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, ErrorCode::not_converged);
  EXPECT_NE(c.error().message.find("the average jumps by 0.37"), std::string::npos) << c.error().message;
}

TEST(Averages, TellInNumbersOrWordsWhereTheyHaveNoRates) {
  const auto c = make_curve("averages", keyframes(random_walk(2269, 5, Spacing::uneven, 3.0)));
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().message.find("nan"), std::string::npos) << c.error().message;
}

}}  // namespace orispline
