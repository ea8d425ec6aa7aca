// SPDX-License-Identifier: Apache-2.0
// monotone: the angles of SciPy's PchipInterpolator, and what docs/families/monotone.md proves: it never turns back
// along a step, and stays near the geodesic between its keys.
#include <set>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/data_table.hpp>
#include <support/near.hpp>
#include <support/properties.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline::testing_support {

/// Random keys whose steps differ in time by up to a hundred million times and turn by up to 340°, some by nothing.
struct WildKeys : RandomKeys {};

[[nodiscard]] inline WildKeys wild_keys(const RandomKeys& drawn, const std::vector<std::pair<int, int>>& changes) {
  WildKeys keys;
  KeyframeData& data = keys.data;
  data.times.push_back(0.0);
  data.orientations.push_back(drawn.data.orientations.front());
  for (std::size_t i = 1; i < drawn.data.times.size(); ++i) {
    const auto& [power, factor] = changes[i - 1];
    const auto& q = drawn.data.orientations;
    data.times.push_back(data.times.back() + std::ldexp(drawn.data.times[i] - drawn.data.times[i - 1], power));
    data.orientations.push_back(data.orientations.back() * exp<double>(factor * increment<double>(q[i - 1], q[i])));
  }
  return keys;
}

}  // namespace orispline::testing_support

namespace rc {

template <>
struct Arbitrary<orispline::testing_support::WildKeys> {
  static Gen<orispline::testing_support::WildKeys> arbitrary() {
    using namespace orispline::testing_support;
    const auto changes =
        gen::container<std::vector<std::pair<int, int>>>(8, gen::pair(gen::inRange(-11, 12), gen::inRange(0, 4)));
    return gen::map(gen::pair(gen::arbitrary<RandomKeys>(), changes),
                    [](const auto& made) { return wild_keys(made.first, made.second); });
  }
};

}  // namespace rc

namespace orispline { namespace {

using namespace testing_support;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double right_angle = pi / 2.0;

AnyCurve monotone_through(const KeyframeData& data) { return make_curve("monotone", keyframes(data)).value(); }

/// Of the page: how far from the geodesic of a step of that angle [rad].
double limit_of(double step) { return step > 0.0 ? 0.375 * (step / 4.0) / std::sin(step / 4.0) * step : 0.0; }

/// How far a point is from the geodesic from p on by `step` [rad].
double distance_to_geodesic(const Quaterniond& p, const Vector3d& step, const Quaterniond& point) {
  const double angle = step.norm();
  const Quaterniond beside = p.conjugate() * point;
  const double along = angle > 0.0 ? beside.vec().dot(step / angle) : 0.0;
  double nearest = 2.0 * std::atan2(along, beside.w());
  if (nearest < 0.0) nearest += 2.0 * pi;
  const auto distance = [&](double at) {
    return angular_distance(point, angle > 0.0 ? p * exp<double>(at / angle * step) : p);
  };
  const double of_ends = std::min(distance(0.0), distance(angle));
  return nearest <= angle ? std::min(of_ends, distance(nearest)) : of_ends;
}

/// What the page proves, at many times of every segment: along the step the turn never goes back, and the curve stays
/// within the limit of the geodesic.
void require_what_the_page_proves(const KeyframeData& data) {
  const AnyCurve curve = monotone_through(data);
  for (std::size_t i = 0; i + 1 < data.times.size(); ++i) {
    const Vector3d step = increment<double>(data.orientations[i], data.orientations[i + 1]);
    const double angle = step.norm(), rounding = tolerance::algebra;
    const Quaterniond middle = data.orientations[i] * exp<double>(Vector3d(0.5 * step));
    double before = -0.5 * angle;
    for (int k = 0; k <= 40; ++k) {
      const double t = data.times[i] + k / 40.0 * (data.times[i + 1] - data.times[i]);
      const Quaterniond q = curve.orientation_on(i, t);
      const double along = angle > 0.0 ? increment<double>(middle, q).dot(step) / angle : 0.0;
      RC_ASSERT(along >= before - rounding);
      RC_ASSERT(along <= 0.5 * angle + rounding);
      RC_ASSERT(distance_to_geodesic(data.orientations[i], step, q) <= limit_of(angle) + rounding);
      before = along;
    }
  }
}

void require_no_jump_of_rates(const AnyCurve& curve) {
  const auto t = curve.knots().times();
  double largest = 0.0;
  for (const double time : t) largest = std::max(largest, curve.motion(time).angular_velocity.norm());
  for (const double time : t)
    require(near(curve.motion(time, Side::left).angular_velocity, curve.motion(time).angular_velocity,
                 tolerance::continuity * std::max(1.0, largest)));
}

TEST(Monotone, IsThePchipInterpolatorOfTheAngle) {
  const DataTable table("scipy_pchip.csv");
  const Vector3d axis(0.6, 0.0, 0.8);
  std::set<std::string> cases;
  for (const auto& row : table.rows()) cases.insert(row.text("case"));
  ASSERT_EQ(cases.size(), 19u);
  for (const std::string& name : cases) {
    SCOPED_TRACE(name);
    const auto rows = table.rows_where("case", name);
    KeyframeData data;
    for (const auto& row : rows) {
      if (row.text("is_key") != "1") continue;
      data.times.push_back(row.number("t"));
      data.orientations.push_back(exp<double>(row.number("angle") * axis));
    }
    const AnyCurve curve = monotone_through(data);
    for (const auto& row : rows) {
      SCOPED_TRACE("t = " + row.text("t"));
      const Motion wanted{.orientation = exp<double>(row.number("angle") * axis),
                          .angular_velocity = row.number("rate") * axis,
                          .angular_acceleration = row.number("acceleration") * axis,
                          .angular_jerk = row.number("jerk") * axis};
      EXPECT_TRUE(near(curve.motion(row.number("t")), wanted, tolerance::golden));
    }
  }
}

TEST(Monotone, NeverTurnsBackAlongAStepAndStaysNearItsGeodesic) {
  EXPECT_TRUE(holds("monotone and near", [](const RandomKeys& keys) { require_what_the_page_proves(keys.data); }));
  EXPECT_TRUE(holds("on wild keys", [](const WildKeys& keys) { require_what_the_page_proves(keys.data); }));
}

TEST(Monotone, HasNoJumpOfItsRatesAtWildKeys) {
  EXPECT_TRUE(holds("C1", [](const WildKeys& keys) { require_no_jump_of_rates(monotone_through(keys.data)); }));
}

/// A step between two that are far quicker and turn at right angles to it: the farthest that the curve gets.
TEST(Monotone, ComesAsNearToItsLimitAsOneLikes) {
  const double small = 1e-4, quick = 1e-7;
  KeyframeData data{.times = {0.0, quick, 1.0 + quick, 1.0 + 2.0 * quick}};
  data.orientations.push_back(Quaterniond::Identity());
  for (const Vector3d& turn : {Vector3d(0.0, 1.0, 0.0), Vector3d(small, 0.0, 0.0), Vector3d(0.0, -1.0, 0.0)})
    data.orientations.push_back(data.orientations.back() * exp<double>(turn));
  const AnyCurve curve = monotone_through(data);
  const double distance = distance_to_geodesic(data.orientations[1], Vector3d(small, 0.0, 0.0), curve(0.5 + quick));
  EXPECT_GT(distance, 0.3749 * small);
  EXPECT_LE(distance, limit_of(small));
}

TEST(Monotone, RestsBetweenOppositeStepsAndBesideARest) {
  const Vector3d turn(0.3, -0.5, 0.7);
  KeyframeData data{.times = {0.0, 0.4, 1.0, 3.0, 3.1}};
  for (const double way : {0.0, 1.0, 0.4, 0.4, 1.0}) data.orientations.push_back(exp<double>(way * turn));
  const AnyCurve curve = monotone_through(data);
  for (const std::size_t key : {1u, 2u, 3u})
    EXPECT_LE(curve.motion(data.times[key]).angular_velocity.norm(), tolerance::algebra) << key;
  for (const double t : {1.0, 1.7, 2.9}) EXPECT_LE(angular_distance(curve(t), data.orientations[2]), tolerance::exact);
}

TEST(Monotone, StandsStillBetweenKeysThatAreNearlyEqual) {
  const double nearly = 0.05 * pi / 180.0;
  const AnyCurve curve = monotone_through(
      {.times = {0.0, 1.0, 2.0, 3.0},
       .orientations = {about_z(0.0), about_z(nearly), about_z(nearly + right_angle), about_z(nearly + right_angle)}});
  for (const double t : sample_times(curve.knots().times(), 50)) {
    const double angle = increment<double>(Quaterniond::Identity(), curve(t)).z();
    EXPECT_GE(angle, -tolerance::exact) << t;
    EXPECT_LE(angle, t <= 1.0 ? nearly + tolerance::exact : nearly + right_angle + tolerance::exact) << t;
  }
}

/// Steps on both sides of where the logarithm, its series and the shortest way change.
TEST(Monotone, GoesOnAcrossVanishingAndHalfTurns) {
  for (const double angle : {0.0, 1e-300, 1e-160, 1e-16, 1e-8, 1e-4, pi - 1e-9, pi, pi + 1e-9, 2.0 * pi - 1e-6}) {
    SCOPED_TRACE(angle);
    KeyframeData data{.times = {0.0, 0.5, 1.5, 1.7}};
    data.orientations.push_back(exp<double>(Vector3d(0.2, -0.1, 0.4)));
    for (const Vector3d& turn :
         {Vector3d(0.5, 0.2, -0.3), Vector3d(angle * Vector3d(0.6, 0.0, 0.8)), Vector3d(0.1, 0.4, 0.2)})
      data.orientations.push_back(data.orientations.back() * exp<double>(turn));
    EXPECT_TRUE(holds("at the threshold", [&] { require_what_the_page_proves(data); }));
    EXPECT_TRUE(holds("C1 there", [&] { require_no_jump_of_rates(monotone_through(data)); }));
  }
}

TEST(Monotone, ChangesLittleWhereAStepVanishesOrPassesHalfATurn) {
  const auto through = [](double angle) {
    return monotone_through(
        {.times = {0.0, 0.5, 1.5, 1.7},
         .orientations = {about_x(-0.4), about_x(0.0), about_z(angle), about_z(angle) * about_x(0.3)}});
  };
  for (const double angle : {0.0, pi}) {
    const AnyCurve at = through(angle), beside = through(angle + 1e-10);
    for (const double t : sample_times(at.knots().times(), 9)) {
      EXPECT_TRUE(near(beside(t), at(t), 1e-9)) << t;
      EXPECT_TRUE(near(beside.motion(t).angular_velocity, at.motion(t).angular_velocity, 1e-8)) << t;
    }
  }
}

TEST(Monotone, PassesPositionsWithoutGoingBackAlongAChord) {
  EXPECT_TRUE(holds("positions", [](const WildKeys& keys) {
    KeyframeData data = keys.data;
    for (const Quaterniond& q : data.orientations) data.positions.push_back(3.0 * q.vec());
    const AnyPath path = *make_pose_curve("monotone", keyframes(data)).value().position;
    for (std::size_t i = 0; i + 1 < data.times.size(); ++i) {
      const Vector3d start = data.positions[i], chord = data.positions[i + 1] - start;
      const double length = chord.norm();
      const Vector3d unit = length > 0.0 ? Vector3d(chord / length) : Vector3d::UnitX();
      double before = 0.0;
      for (int k = 0; k <= 40; ++k) {
        const double t = data.times[i] + k / 40.0 * (data.times[i + 1] - data.times[i]);
        const Vector3d beside = path.position_on(i, t) - start;
        const double along = beside.dot(unit);
        RC_ASSERT(along >= before - tolerance::algebra);
        RC_ASSERT(along <= length + tolerance::algebra);
        RC_ASSERT((beside - along * unit).norm() <= 0.375 * length + tolerance::algebra);
        before = along;
      }
    }
  }));
}

}}  // namespace orispline
