// SPDX-License-Identifier: Apache-2.0
// Contract: a family that closes runs through its seam as through any key; one that does not says so.
#include <contract/family_contract.hpp>
#include <contract/random_parameters.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

constexpr std::size_t key_count = 6;
constexpr double even_step = 0.5;

KeyframeData loop_walk(std::uint64_t seed, Spacing spacing) {
  KeyframeData data = random_walk(seed, key_count, spacing, 0.8);
  Dice dice(seed + 1);
  for (std::size_t i = 0; i < key_count; ++i) data.positions.push_back(3.0 * dice.vector());
  return data;
}

/// A period that continues even times evenly and uneven ones with a step of their own.
double period_of(const KeyframeData& data, Spacing spacing) {
  return data.times.back() - data.times.front() + (spacing == Spacing::even ? even_step : 0.37);
}

/// Values of every per-key parameter that differ from key to key.
CurveOptions differing_parameters(const FamilyInfo& family, std::size_t keys, double period) {
  CurveOptions options{.loop = Loop{period}};
  Dice dice(81);
  for (const Parameter& p : family.parameters)
    if (p.per_key)
      for (std::size_t i = 0; i < keys; ++i)
        options.parameters[std::string(p.name)].push_back(p.initial + dice.between(0.0, 0.3));
  return options;
}

/// Those but the ones that are jumps.
CurveOptions differing_smooth_parameters(const FamilyInfo& family, std::size_t keys, double period) {
  CurveOptions options = differing_parameters(family, keys, period);
  std::erase_if(options.parameters, [&](const auto& entry) { return is_a_jump(family, entry.first); });
  return options;
}

class ClosedContract : public FamilyContract {
 protected:
  [[nodiscard]] static PoseCurve closed(const Keyframes& keys, const CurveOptions& options) {
    return make_pose_curve({GetParam().name, options}, keys).value();
  }
  [[nodiscard]] static int continuity(Spacing spacing) {
    return spacing == Spacing::even ? GetParam().continuity_uniform : GetParam().continuity_uneven;
  }
  [[nodiscard]] static int continuity_with_parameters(Spacing spacing) {
    return std::min(continuity(spacing), use().smoothest_with_parameters);
  }

  /// Compares the motion at the end with that at the start, order by order, relative to its size along the curve.
  static void expect_seam_of_order(const AnyCurve& c, int continuity) {
    const Motion start = c.motion(c.domain().start), end = c.motion(c.domain().end);
    const double sign = start.orientation.dot(end.orientation) < 0.0 ? -1.0 : 1.0;
    EXPECT_TRUE(near(end.orientation, Eigen::Quaterniond(sign * start.orientation.coeffs()), tolerance::algebra));
    const std::array<double, 3> jumps{(end.angular_velocity - start.angular_velocity).norm(),
                                      (end.angular_acceleration - start.angular_acceleration).norm(),
                                      (end.angular_jerk - start.angular_jerk).norm()};
    std::array<double, 3> sizes{};
    for (const double t : times_on(c)) {
      const Motion m = c.motion(t);
      sizes = {std::max(sizes[0], m.angular_velocity.norm()), std::max(sizes[1], m.angular_acceleration.norm()),
               std::max(sizes[2], m.angular_jerk.norm())};
    }
    const auto order = static_cast<std::size_t>(continuity);
    for (std::size_t k = 0; k < std::min<std::size_t>(order, 3); ++k)
      EXPECT_LE(jumps[k], tolerance::continuity * sizes[k]) << "order " << k + 1;
    if (order < 3) {
      EXPECT_GE(jumps[order], tolerance::visible_jump * sizes[order]) << "order " << order + 1;
    }
  }
};

TEST_P(ClosedContract, SeamIsAsSmoothAsDeclared) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven})
    for (const std::uint64_t seed : {82u, 83u}) {
      SCOPED_TRACE(seed);
      const KeyframeData data = loop_walk(seed, spacing);
      expect_seam_of_order(closed(keyframes(data), {.loop = Loop{period_of(data, spacing)}}).orientation,
                           continuity(spacing));
    }
}

TEST_P(ClosedContract, SeamIsAsSmoothWithParametersOfTheirOwnAtEveryKey) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const KeyframeData data = loop_walk(84, spacing);
    const CurveOptions options = differing_smooth_parameters(GetParam(), key_count, period_of(data, spacing));
    expect_seam_of_order(closed(keyframes(data), options).orientation, continuity_with_parameters(spacing));
  }
}

TEST_P(ClosedContract, PassesThroughEveryKeyIfItInterpolatesAndReturnsAfterThePeriod) {
  const KeyframeData data = loop_walk(85, Spacing::uneven);
  const double period = period_of(data, Spacing::uneven);
  const PoseCurve c = closed(keyframes(data), {.loop = Loop{period}});
  EXPECT_EQ(c.orientation.domain().start, data.times.front());
  EXPECT_DOUBLE_EQ(c.orientation.domain().end, data.times.front() + period);
  EXPECT_EQ(c.orientation.knots().segments(), key_count);
  for (std::size_t i = 0; GetParam().interpolates && i < key_count; ++i) {
    EXPECT_TRUE(near(c.orientation(data.times[i]), data.orientations[i], tolerance::algebra));
    EXPECT_TRUE(near(c.position->linear_motion(data.times[i]).position, data.positions[i], tolerance::algebra));
  }
}

TEST_P(ClosedContract, PositionsReturnAsSmoothlyAsOrientations) {
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const KeyframeData data = loop_walk(86, spacing);
    const PoseCurve c =
        closed(keyframes(data), differing_smooth_parameters(GetParam(), key_count, period_of(data, spacing)));
    const LinearMotion start = c.position->linear_motion(c.orientation.domain().start);
    const LinearMotion end = c.position->linear_motion(c.orientation.domain().end);
    EXPECT_TRUE(near(end.position, start.position, tolerance::algebra));
    if (continuity_with_parameters(spacing) >= 1) {
      EXPECT_TRUE(near(end.velocity, start.velocity, tolerance::rates));
    } else {
      EXPECT_GT((end.velocity - start.velocity).norm(), tolerance::visible_jump);
    }
    if (continuity_with_parameters(spacing) >= 2) {
      EXPECT_TRUE(near(end.acceleration, start.acceleration, tolerance::rates));
    }
  }
}

TEST_P(ClosedContract, DoesNotDependOnTheKeyThatItStartsFrom) {
  // The keys from key 2 on, keys 0 and 1 after them a period later: the same curve, its parameters carried along.
  const KeyframeData data = loop_walk(87, Spacing::uneven);
  const double period = period_of(data, Spacing::uneven);
  const CurveOptions options = differing_parameters(GetParam(), key_count, period);
  KeyframeData shifted = data;
  CurveOptions shifted_options = options;
  const auto shift = [](auto& values) { std::rotate(values.begin(), values.begin() + 2, values.end()); };
  shift(shifted.times);
  shift(shifted.orientations);
  shift(shifted.positions);
  for (auto& [name, values] : shifted_options.parameters) shift(values);
  for (const std::size_t late : {key_count - 2, key_count - 1}) shifted.times[late] += period;

  const PoseCurve c = closed(keyframes(data, Signs::shortest), options);
  const PoseCurve d = closed(keyframes(shifted, Signs::shortest), shifted_options);

  for (const double t : times_on(c.orientation)) {
    const double later = t < shifted.times.front() ? t + period : t;
    EXPECT_LE(angular_distance(d.orientation(later), c.orientation(t)), tolerance::series) << t;
    EXPECT_TRUE(
        near(d.position->linear_motion(later).position, c.position->linear_motion(t).position, tolerance::series))
        << t;
  }
}

TEST_P(ClosedContract, FullTurnGoesOnAcrossTheSeam) {
  // Five keys evenly round one axis: on S³ the loop ends at minus its start.
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  KeyframeData data;
  for (int i = 0; i < 5; ++i) {
    data.times.push_back(i);
    data.orientations.push_back(exp<double>(2.0 * pi / 5.0 * i * axis));
  }
  const AnyCurve c = curve(keyframes(data, Signs::shortest), {.loop = Loop{5.0}});
  EXPECT_TRUE(near(c(5.0), Eigen::Quaterniond(-c(0.0).coeffs()), tolerance::algebra));
  EXPECT_LE(angular_distance(c(4.5), exp<double>(0.9 * 2.0 * pi * axis)), tolerance::series);
  double deviation = 0.0;
  for (const double t : times_on(c))
    deviation = std::max(deviation, (c.motion(t).angular_velocity - 2.0 * pi / 5.0 * axis).norm());
  EXPECT_EQ(deviation <= tolerance::rates, GetParam().keeps_constant_rate_uniform);
}

TEST_P(ClosedContract, ClosingKeyIsAsGoodAsAPeriod) {
  for (const double sign : {1.0, -1.0}) {
    const KeyframeData data = loop_walk(88, Spacing::uneven);
    const double period = period_of(data, Spacing::uneven);
    KeyframeData with_key = data;
    with_key.times.push_back(data.times.front() + period);
    with_key.orientations.emplace_back(sign * data.orientations.front().coeffs());
    with_key.positions.push_back(data.positions.front());
    CurveOptions options = differing_parameters(GetParam(), key_count, period), of_the_key = options;
    for (const Parameter& p : GetParam().parameters)  // the first key's counts
      if (p.per_key) of_the_key.parameters[std::string(p.name)].push_back(std::max(p.lowest, -1.0));
    of_the_key.loop = Loop{};
    // Signs::shortest turns the closing key to the nearer side: both signs are one loop.
    const PoseCurve by_period = closed(keyframes(data, Signs::shortest), options);
    const PoseCurve by_key = closed(keyframes(with_key, Signs::shortest), of_the_key);
    ASSERT_EQ(by_key.orientation.knots().segments(), key_count);
    for (const double t : times_on(by_period.orientation)) {
      EXPECT_TRUE(near(by_key.orientation.motion(t), by_period.orientation.motion(t), same_motion)) << t;
      EXPECT_TRUE(near(by_key.position->linear_motion(t).position, by_period.position->linear_motion(t).position,
                       tolerance::algebra));
    }
  }
}

TEST_P(ClosedContract, ClosingKeyWithSignsAsGivenTakesTheLongWay) {
  KeyframeData data;
  for (const double angle : {0.0, 1.2, 2.4, 0.0}) {
    const double tilt = angle == 1.2 ? 0.5 : 0.0;  // about one axis some are smoother than declared
    data.times.push_back(static_cast<double>(data.times.size()));
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0, tilt, angle)));
  }
  const AnyCurve shorter = curve(keyframes(data), {.loop = Loop{}});
  data.orientations.back().coeffs() *= -1.0;
  const AnyCurve longer = curve(keyframes(data), {.loop = Loop{}});
  EXPECT_TRUE(near(shorter(3.0), shorter(0.0), tolerance::algebra));
  EXPECT_TRUE(near(longer(3.0), Eigen::Quaterniond(-longer(0.0).coeffs()), tolerance::algebra));
  if (GetParam().interpolates) {
    EXPECT_TRUE(near(shorter(0.0), Eigen::Quaterniond::Identity(), tolerance::algebra));
    EXPECT_TRUE(near(longer(0.0), Eigen::Quaterniond::Identity(), tolerance::algebra));
  }
  expect_seam_of_order(longer, continuity(Spacing::even));
  EXPECT_GT(angular_distance(longer(2.5), shorter(2.5)), 1.0);
}

TEST_P(ClosedContract, TwoKeysMakeALoopToAndFroOnTheirGreatArc) {
  const KeyframeData data = random_walk(89, 2, Spacing::even);
  const AnyCurve c = curve(keyframes(data), {.loop = Loop{2.0 * even_step}});
  const Eigen::Vector3d step = increment<double>(data.orientations[0], data.orientations[1]);
  for (const double t : times_on(c)) {
    EXPECT_LE(increment<double>(data.orientations[0], c(t)).cross(step).norm(), tolerance::algebra);
    EXPECT_LE(angular_distance(c(t), c(2.0 * data.times[1] - t)), tolerance::algebra);
  }
  for (const double t : c.knots().times())
    EXPECT_TRUE(near(c.motion(t).angular_velocity, Eigen::Vector3d::Zero(), tolerance::series));
  if (GetParam().interpolates) {
    EXPECT_TRUE(near(c(data.times[1]), data.orientations[1], tolerance::algebra));
  }
}

std::vector<FamilyInfo> closing_families() {
  std::vector<FamilyInfo> families(families_info().begin(), families_info().end());
  std::erase_if(families, [](const FamilyInfo& family) { return !family.closes; });
  return families;
}

INSTANTIATE_TEST_SUITE_P(Family, ClosedContract, testing::ValuesIn(closing_families()), test_name);

class RefusesToClose : public FamilyContract {};

TEST_P(RefusesToClose, UnlessItIsDeclaredToClose) {
  const KeyframeData data = walk(90, 4, Spacing::even);
  const auto c = make_curve({GetParam().name, {.loop = Loop{period_of(data, Spacing::even)}}}, keyframes(data));
  ASSERT_EQ(c.has_value(), GetParam().closes);
  if (c) return;
  EXPECT_EQ(c.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(c.error().message, std::string(GetParam().name) + ": this method has no closed curves");
}

ORISPLINE_FOR_EVERY_FAMILY(RefusesToClose);

}}  // namespace orispline::contract
