// SPDX-License-Identifier: Apache-2.0
// Keys that bring rates and values of parameters, and settings on which the keys of a segment depend: the bits of the
// curve through all of them.
#include <gtest/gtest.h>

#include <online/online_stream.hpp>
#include <support/inner_quaternions.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr std::size_t keys_of_stream = 40;

/// How many of the times on the final segments have other bits than the curve through all keys.
int differing(const OnlineCurve& online, const PoseCurve& offline) {
  const Domain domain = online.available().value();
  int wrong = 0;
  for (int k = 0; k < 400; ++k) {
    const double t = domain.start + (domain.end - domain.start) * k / 400.0;
    const Motion a = online.motion(t), b = offline.orientation.motion(t);
    wrong += a.orientation.coeffs() == b.orientation.coeffs() && a.angular_jerk == b.angular_jerk ? 0 : 1;
  }
  return wrong;
}

/// A stream of the keys with the values of the options at each of them against the curve through all keys.
void expect_same_bits(std::string_view method, const KeyframeData& data, const CurveOptions& options) {
  CurveOptions of_stream = options;
  for (auto& [name, values] : of_stream.parameters)
    if (values.size() > 1) values.clear();
  const auto offline = make_pose_curve({method, options}, keyframes(data, Signs::shortest));
  ASSERT_TRUE(offline) << describe(offline.error());
  OnlineCurve online = OnlineCurve::make({method, of_stream}, keys_of_stream).value();
  for (std::size_t i = 0; i < keys_of_stream; ++i) {
    StreamKey key = key_of(data, i);
    for (const auto& [name, values] : options.parameters)
      if (values.size() > 1) key.settings.emplace(name, values[i]);
    const auto taken = online.append(key);
    ASSERT_TRUE(taken) << describe(taken.error());
    if (online.available()->start < online.available()->end) {
      EXPECT_EQ(differing(online, *offline), 0) << method << " after key " << i;
    }
  }
  ASSERT_TRUE(online.finish());
  EXPECT_EQ(online.available()->end, offline->orientation.domain().end);
  EXPECT_EQ(differing(online, *offline), 0) << method;
}

TEST(OnlineCurve, TakesParametersThatComeWithTheKeysOfEveryMethod) {
  const KeyframeData data = raw_walk(711, keys_of_stream);
  for (const std::string_view method : OnlineCurve::methods()) {
    Dice dice(712);
    CurveOptions options;
    for (const Parameter& parameter : find_family(method).value()->parameters) {
      if (!parameter.per_key) continue;
      auto& values = options.parameters[std::string(parameter.name)];
      for (std::size_t i = 0; i < keys_of_stream; ++i) values.push_back(parameter.initial + dice.between(0.05, 0.4));
    }
    if (!options.parameters.empty()) expect_same_bits(method, data, options);
  }
}

TEST(OnlineCurve, TakesRatesOfTheKeys) {
  KeyframeData data = raw_walk(713, keys_of_stream);
  Dice dice(714);
  for (std::size_t i = 0; i < keys_of_stream; ++i) {
    data.angular_velocities.push_back(dice.vector());
    data.angular_accelerations.push_back(dice.vector());
    data.angular_jerks.push_back(dice.vector());
  }
  for (const std::string_view method : OnlineCurve::methods())
    if (find_family(method).value()->rate_orders > 0) expect_same_bits(method, data, {});
}

TEST(OnlineCurve, TakesInnerQuaternionsOfTheKeys) {
  KeyframeData data = with_inner_quaternions(raw_walk(719, keys_of_stream), 720);
  data.inner_leaving[7] = data.inner_arriving[9] = free_inner();
  for (const std::string_view method : OnlineCurve::methods())
    if (find_family(method).value()->takes_inner_quaternions()) expect_same_bits(method, data, {});
}

TEST(OnlineCurve, HoldsEqualKeysAtRest) {
  KeyframeData data = raw_walk(715, keys_of_stream);
  for (const std::size_t i : {1u, 9u, 10u, 21u, 33u, 39u}) data.orientations[i] = data.orientations[i - 1];
  for (const std::string_view method : {"auto", "auto5"})
    expect_same_bits(method, data, {.parameters = {{"hold", {1.0}}}});
}

TEST(OnlineCurve, LooksAsFarAsTheDegreeOfABSpline) {
  const KeyframeData data = raw_walk(716, keys_of_stream);
  for (const double degree : {2.0, 3.0, 4.0, 5.0})
    expect_same_bits("bspline", data, {.parameters = {{"degree", {degree}}}});
}

TEST(OnlineCurve, RefusesAKeyWithoutTheSettingsThatItShouldBring) {
  const KeyframeData data = raw_walk(717, 9);
  OnlineCurve curve = OnlineCurve::make({"timed-c2", {.parameters = {{"tension", {}}}}}, 8).value();
  OnlineCurve undisturbed = OnlineCurve::make({"timed-c2", {.parameters = {{"tension", {}}}}}, 8).value();
  const auto refused = [&](std::map<std::string, double, std::less<>> settings) {
    StreamKey key = key_of(data, 5);
    key.settings = std::move(settings);
    const auto taken = curve.append(key);
    return taken ? "taken" : describe(taken.error());
  };
  const auto append_both = [&](std::size_t i) {
    StreamKey key = key_of(data, i);
    key.settings = {{"tension", 0.3 + 0.05 * static_cast<double>(i)}};
    return curve.append(key).has_value() && undisturbed.append(key).has_value();
  };
  for (std::size_t i = 0; i < 5; ++i) ASSERT_TRUE(append_both(i));
  EXPECT_EQ(refused({}), "key 5: timed-c2: found values of [] with the key, wanted those of [tension]");
  EXPECT_EQ(refused({{"tension", 0.5}, {"tension2", 1.0}}),
            "key 5: timed-c2: found values of [tension, tension2] with the key, wanted those of [tension]");
  EXPECT_EQ(refused({{"bias", 1.0}}), "key 5: timed-c2: unknown parameter 'bias', wanted one of tension, tension2");
  EXPECT_EQ(refused({{"tension", 101.0}}), "key 5: timed-c2: tension is 101, wanted -100 to 100");
  for (std::size_t i = 5; i < 9; ++i) ASSERT_TRUE(append_both(i));
  const double t = curve.available()->end - 0.01;
  EXPECT_EQ(curve(t).coeffs(), undisturbed(t).coeffs());
}

TEST(OnlineCurve, RefusesAKeyWhoseSettingsMakeNoCurve) {
  const KeyframeData data = raw_walk(718, 12);
  OnlineCurve curve = OnlineCurve::make({"beta", {.parameters = {{"beta2", {}}}}}, 8).value();
  const auto append = [&](std::size_t i, double beta2) {
    StreamKey key = key_of(data, i);
    key.settings = {{"beta2", beta2}};
    return curve.append(key);
  };
  for (std::size_t i = 0; i < 6; ++i) ASSERT_TRUE(append(i, 0.1));
  const auto refused = append(6, -1000.0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where.key, 6u);
  EXPECT_EQ(curve.keys(), 6u);
  EXPECT_EQ(curve.available()->end, data.times[4]);
  EXPECT_TRUE(append(6, 0.2));
  EXPECT_EQ(curve.available()->end, data.times[5]);
}

}}  // namespace orispline
