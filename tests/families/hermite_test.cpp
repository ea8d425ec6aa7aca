// SPDX-License-Identifier: Apache-2.0
// Hermite curves of orders 1 to 3: rates given or estimated, exact at the keys, in both forms.
#include <ostream>

#include <gtest/gtest.h>

#include <orispline/families/hermite.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Order 1 to 3 in one of the two forms.
struct HermiteForm {
  std::size_t order;
  const char* form;

  [[nodiscard]] std::string name() const { return "hermite-c" + std::to_string(order); }
  [[nodiscard]] AnyCurve through(const Keyframes& keys, const char* stencil = "5") const {
    return make_curve({name(), {.choices = {{"form", form}, {"stencil", stencil}}}}, keys).value();
  }
};

void PrintTo(const HermiteForm& method, std::ostream* out) { *out << method.name() << ' ' << method.form; }

class Hermite : public testing::TestWithParam<HermiteForm> {};

INSTANTIATE_TEST_SUITE_P(Form, Hermite,
                         testing::Values(HermiteForm{1, "chart"}, HermiteForm{2, "chart"}, HermiteForm{3, "chart"},
                                         HermiteForm{1, "cumulative"}, HermiteForm{2, "cumulative"},
                                         HermiteForm{3, "cumulative"}),
                         [](const auto& test) { return test.param.form + std::to_string(test.param.order); });

std::array<Eigen::Vector3d, 3> rates_of(const Motion& m) {
  return {m.angular_velocity, m.angular_acceleration, m.angular_jerk};
}

using RatesOfKeys = std::vector<Eigen::Vector3d> KeyframeData::*;
constexpr std::array<RatesOfKeys, 3> rates_by_order{&KeyframeData::angular_velocities,
                                                    &KeyframeData::angular_accelerations, &KeyframeData::angular_jerks};

KeyframeData keys_with_rates(std::uint64_t seed, Spacing spacing) {
  KeyframeData data = random_walk(seed, 6, spacing);
  Dice dice(seed + 1);
  for (const RatesOfKeys rates : rates_by_order)
    for (std::size_t i = 0; i < 6; ++i) (data.*rates).push_back(2.0 * dice.vector());
  return data;
}

TEST_P(Hermite, HasTheGivenRatesOnBothSidesOfEveryKey) {
  const KeyframeData data = keys_with_rates(341, Spacing::uneven);
  const AnyCurve c = GetParam().through(keyframes(data));
  for (std::size_t i = 0; i < data.times.size(); ++i)
    for (const Side side : {Side::left, Side::right}) {
      const Motion m = c.motion(data.times[i], side);
      EXPECT_TRUE(near(m.orientation, data.orientations[i], tolerance::series)) << i;
      for (std::size_t k = 0; k < GetParam().order; ++k)
        EXPECT_TRUE(near(rates_of(m)[k], (data.*rates_by_order[k])[i], tolerance::rates))
            << "order " << k + 1 << " at key " << i;
    }
}

TEST_P(Hermite, EstimatesTheOrdersThatTheKeysLack) {
  const KeyframeData all = keys_with_rates(342, Spacing::uneven), none = random_walk(342, 6, Spacing::uneven);
  KeyframeData some = none;
  some.angular_velocities = all.angular_velocities;
  const AnyCurve estimated = GetParam().through(keyframes(none)), c = GetParam().through(keyframes(some));
  for (std::size_t i = 0; i < 6; ++i) {
    const auto found = rates_of(c.motion(all.times[i])), wanted = rates_of(estimated.motion(all.times[i]));
    EXPECT_TRUE(near(found[0], all.angular_velocities[i], tolerance::series));
    for (std::size_t k = 1; k < GetParam().order; ++k) EXPECT_TRUE(near(found[k], wanted[k], tolerance::rates)) << k;
  }
}

TEST_P(Hermite, DoesNotLookAtOrdersThatItHasNoUseFor) {
  const KeyframeData all = keys_with_rates(343, Spacing::uneven);
  KeyframeData fewer = all;
  for (std::size_t k = GetParam().order; k < 3; ++k) (fewer.*rates_by_order[k]).clear();
  const AnyCurve c = GetParam().through(keyframes(all)), d = GetParam().through(keyframes(fewer));
  for (const double t : sample_times(all.times)) EXPECT_EQ(c(t).coeffs(), d(t).coeffs());
}

TEST_P(Hermite, IsAsSmoothInTimeAsItsNameSaysAndNoSmoother) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const KeyframeData data = keys_with_rates(344, spacing);
    const auto jumps_of = [&]<std::size_t K>(families::Hermite<K>*) {
      const FamilySettings settings = settle(families::Hermite<K>::info, {}, 6).value();
      return GetParam().form == std::string("chart")
                 ? relative_jumps(families::Hermite<K>::chart(keyframes(data), settings).value())
                 : relative_jumps(families::Hermite<K>::cumulative(keyframes(data), settings).value());
    };
    const auto jumps = GetParam().order == 1   ? jumps_of(static_cast<families::HermiteC1*>(nullptr))
                       : GetParam().order == 2 ? jumps_of(static_cast<families::HermiteC2*>(nullptr))
                                               : jumps_of(static_cast<families::HermiteC3*>(nullptr));
    for (std::size_t k = 0; k <= GetParam().order; ++k) EXPECT_LE(jumps[k], tolerance::continuity) << "order " << k;
    EXPECT_GE(jumps[GetParam().order + 1], tolerance::visible_jump);
  }
}

TEST_P(Hermite, TurnsAboutAFixedAxisByTheHermitePolynomialOfTheAngle) {
  // Any polynomial of degree 2K+1 is the one through its own derivatives.
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  const auto angle = [degree = 2 * GetParam().order + 1](double t) {
    const auto x = Jet<double, 3>::variable(t);
    Jet<double, 3> sum(0.2), power(1.0);
    for (std::size_t i = 1; i <= degree; ++i) {
      power *= x;
      sum += power * (i % 2 == 0 ? -0.3 : 0.25);
    }
    return sum;
  };
  KeyframeData data{.times = {0.0, 0.4, 0.5, 1.1}};
  for (const double t : data.times) {
    data.orientations.push_back(exp<double>(angle(t).c[0] * axis));
    for (std::size_t k = 0; k < 3; ++k) (data.*rates_by_order[k]).push_back(angle(t).derivative(k + 1) * axis);
  }
  const AnyCurve c = GetParam().through(keyframes(data));
  for (const double t : sample_times(data.times)) {
    EXPECT_TRUE(near(c(t), exp<double>(angle(t).c[0] * axis), tolerance::series)) << t;
    EXPECT_TRUE(near(c.motion(t).angular_jerk, angle(t).derivative(3) * axis, tolerance::rates)) << t;
  }
}

TEST_P(Hermite, OfTwoKeysWithoutRatesIsTheGreatArcAtConstantRate) {
  const KeyframeData data = random_walk(345, 2, Spacing::even);
  const AnyCurve c = GetParam().through(keyframes(data));
  const Eigen::Vector3d rate = increment<double>(data.orientations[0], data.orientations[1]) / 0.5;
  for (const double t : sample_times(data.times, 8)) {
    EXPECT_TRUE(near(c.motion(t).angular_velocity, rate, tolerance::series)) << t;
    EXPECT_TRUE(near(c.motion(t).angular_acceleration, Eigen::Vector3d::Zero(), tolerance::rates)) << t;
  }
}

TEST_P(Hermite, WithThreeKeysDependsOnFourAndWithFiveOnSix) {
  const auto reach = [](const char* stencil) {
    KeyframeData data = random_walk(346, 12, Spacing::uneven);
    const AnyCurve before = GetParam().through(keyframes(data), stencil);
    std::size_t reached = 0;
    for (std::size_t moved = 0; moved < 12; ++moved) {
      KeyframeData other = data;
      other.orientations[moved] = other.orientations[moved] * exp<double>(Eigen::Vector3d(0.3, -0.2, 0.4));
      const double t = 0.5 * (data.times[5] + data.times[6]);
      reached += before(t).coeffs() != GetParam().through(keyframes(other), stencil)(t).coeffs();
    }
    return reached;
  };
  EXPECT_EQ(reach("3"), 4u);
  EXPECT_EQ(reach("5"), 6u);
}

TEST(HermiteStencil, OfThreeKeysGivesTheRatesOfTheParabola) {
  const KeyframeData data = random_walk(347, 5, Spacing::uneven);
  const AnyCurve c = HermiteForm{2, "chart"}.through(keyframes(data), "3");
  for (std::size_t i = 1; i + 1 < 5; ++i) {
    const double before = data.times[i] - data.times[i - 1], after = data.times[i + 1] - data.times[i];
    const Eigen::Vector3d back = -increment<double>(data.orientations[i], data.orientations[i - 1]) / before;
    const Eigen::Vector3d ahead = increment<double>(data.orientations[i], data.orientations[i + 1]) / after;
    const Motion m = c.motion(data.times[i]);
    EXPECT_TRUE(near(m.angular_velocity, (after * back + before * ahead) / (before + after), tolerance::rates));
    EXPECT_TRUE(near(m.angular_acceleration, 2.0 * (ahead - back) / (before + after), tolerance::rates));
  }
}

TEST(HermitePaths, HaveTheDerivativesOfThePolynomialThroughFivePositions) {
  KeyframeData data = random_walk(348, 5, Spacing::uneven);
  const auto position = [](const Jet<double, 2>& t) {  // of degree 4: the stencil of five keys finds it
    return Vector3<Jet<double, 2>>(t * t * t * t, t * 2.0 - t * t, t * t * t * 0.5 + Jet<double, 2>(1.0));
  };
  for (const double t : data.times) {
    const auto p = position(t);
    data.positions.emplace_back(p.x().c[0], p.y().c[0], p.z().c[0]);
  }
  for (const std::size_t order : {2u, 3u}) {
    const auto pose = make_pose_curve("hermite-c" + std::to_string(order), keyframes(data)).value();
    for (const double t : sample_times(data.times)) {
      const auto p = position(Jet<double, 2>::variable(t));
      const LinearMotion linear_motion = pose.position->linear_motion(t);
      const auto wanted = [&](std::size_t k) {
        return Eigen::Vector3d(p.x().derivative(k), p.y().derivative(k), p.z().derivative(k));
      };
      EXPECT_TRUE(near(linear_motion.position, wanted(0), tolerance::series)) << t;
      EXPECT_TRUE(near(linear_motion.velocity, wanted(1), tolerance::rates)) << t;
      EXPECT_TRUE(near(linear_motion.acceleration, wanted(2), tolerance::rates)) << t;
    }
  }
}

TEST(HermiteChart, RefusesAFullTurnAndNamesTheKeyBeforeIt) {
  const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.3, 0.1, -0.2));
  const Keyframes keys =
      keyframes({.times = {0.0, 1.0, 2.0}, .orientations = {q, q, Eigen::Quaterniond(-q.coeffs())}}, Signs::as_given);
  const auto chart = make_curve("hermite-c2", keys);
  ASSERT_FALSE(chart);
  EXPECT_EQ(chart.error().code, ErrorCode::bad_data);
  EXPECT_EQ(chart.error().where.key, 1u);
  EXPECT_TRUE(make_curve({"hermite-c2", {.choices = {{"form", "cumulative"}}}}, keys));
}

// ------------------------------------------------------------------------------------------------ order of accuracy

/// A smooth motion whose angular velocities at different times do not commute, with exact rates.
template <Number T>
Quaternion<T> motion_with_rates(const T& t) {
  const T t2 = t * t, t3 = t2 * t, t4 = t3 * t, t5 = t4 * t;
  const Vector3<T> first(t * 0.9 - t3 * 0.15 + t5 * 0.01, t * 0.5, T(0.3) - t2 * 0.25 + t4 * 0.04);
  const Vector3<T> second(t2 * 0.2, T(-0.4) + t2 * 0.2 - t4 * 0.02, t * 0.42 - t3 * 0.034);
  return exp<T>(first) * exp<T>(second);
}

enum class Source { exact_rates, five_keys, three_keys };

double error_with(const HermiteForm& method, Source source, std::size_t segments) {
  KeyframeData data;
  for (std::size_t i = 0; i <= segments; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(segments);
    data.times.push_back(2.0 * (std::pow(4.0, x) - 1.0) / 3.0);  // the last step is four times the first
    const Motion m = motion_from_jet(motion_with_rates(Jet<double, 3>::variable(data.times.back())));
    data.orientations.push_back(m.orientation);
    if (source != Source::exact_rates) continue;
    for (std::size_t k = 0; k < 3; ++k) (data.*rates_by_order[k]).push_back(rates_of(m)[k]);
  }
  const AnyCurve c = method.through(keyframes(data), source == Source::three_keys ? "3" : "5");
  double largest = 0.0;
  for (const double t : sample_times(data.times, 10))
    largest = std::max(largest, angular_distance(c(t), motion_with_rates(t)));
  return largest;
}

double observed_order(const HermiteForm& method, Source source, std::size_t segments) {
  return std::log2(error_with(method, source, segments) / error_with(method, source, 2 * segments));
}

TEST(HermiteAccuracy, OfTheChartWithExactRatesIsTwiceTheOrderPlusTwo) {
  for (const std::size_t order : {1u, 2u, 3u})
    EXPECT_NEAR(observed_order({order, "chart"}, Source::exact_rates, order == 3 ? 32 : 64),
                2.0 * static_cast<double>(order) + 2.0, 0.3);
}

TEST(HermiteAccuracy, OfTheCumulativeFormIsThreeWhateverItsDegree) {
  for (const std::size_t order : {1u, 2u, 3u})
    for (const Source source : {Source::exact_rates, Source::five_keys})
      EXPECT_NEAR(observed_order({order, "cumulative"}, source, 128), 3.0, 0.4) << order;
}

TEST(HermiteAccuracy, OfTheChartWithEstimatedRatesIsThatOfTheStencil) {
  const std::array five_keys{4.0, 5.0, 5.0};
  for (const std::size_t order : {1u, 2u, 3u})
    EXPECT_NEAR(observed_order({order, "chart"}, Source::five_keys, 128), five_keys[order - 1], 0.3) << order;
  for (const std::size_t order : {1u, 2u})
    EXPECT_NEAR(observed_order({order, "chart"}, Source::three_keys, 128), 3.0, 0.3) << order;
}

TEST(Hermite, RefusesRatesThatWindTheCurveFartherThanDoublesTellItsOrientation) {
  KeyframeData data = random_walk(391, 4, Spacing::even, 0.5);
  for (const double rate : {1e2, 1e12}) {
    data.angular_velocities.assign(4, Eigen::Vector3d(0, rate, 0));
    for (const char* family : {"hermite-c1", "hermite-c2", "hermite-c3"})
      for (const char* form : {"chart", "cumulative"}) {
        const auto made = make_curve({family, {.choices = {{"form", form}}}}, keyframes(data));
        EXPECT_EQ(made.has_value(), rate == 1e2) << family << ' ' << form;
      }
  }
}

/// Four quick keys and a late one: the polynomial through all five is used far outside the quick ones.
TEST(Hermite, RefusesEstimatedRatesThatWindTheCurveAndNamesBothKeys) {
  KeyframeData data = random_walk(392, 5, Spacing::even, 0.5);
  data.times = {0.0, 0.003, 0.073, 0.1, 98.0};
  const auto made = make_curve("hermite-c2", keyframes(data));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::bad_data);
  EXPECT_EQ(made.error().where.key, 3U);
  EXPECT_TRUE(made.error().message.starts_with(
      "hermite-c2: the rates at this key and the next one wind the curve between the two by up to"))
      << made.error().message;
  EXPECT_TRUE(make_curve("squad", keyframes(data)));
}

}}  // namespace orispline
