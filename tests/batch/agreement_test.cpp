// SPDX-License-Identifier: Apache-2.0
// Samples in bulk against the scalar evaluator for every family: random keys, and the far corners of what is allowed.
#include <batch/agreement.hpp>
#include <orispline/families/registry.hpp>
#include <support/key_use.hpp>
#include <support/properties.hpp>

namespace orispline { namespace {

using namespace testing_support;

[[nodiscard]] ::testing::AssertionResult agree_in_both(const AnyCurve& curve, std::size_t samples_per_segment) {
  const std::vector<double> times = sample_times(curve.knots().times(), samples_per_segment);
  if (auto ok = agree<double>(curve, times); !ok) return ok;
  return agree<float>(curve, times);
}

class BatchOfFamily : public testing::TestWithParam<std::string> {};

TEST_P(BatchOfFamily, AgreesWithTheScalarEvaluatorOnRandomKeys) {
  const FamilyInfo& family = *find_family(GetParam()).value();
  const auto agrees = [&](const RandomKeys& random) {
    const auto curve = make_curve(family.name, keyframes(fitting(family, random)));
    if (!curve) RC_DISCARD("refused");
    require(agree_in_both(*curve, 2));
    require(agree_in_both(*curve, 13));
  };
  EXPECT_TRUE(holds(std::string(family.name) + " in bulk", agrees));
}

TEST_P(BatchOfFamily, AgreesFarOutsideTheUsualRangeOfItsParameters) {
  const FamilyInfo& family = *find_family(GetParam()).value();
  const KeyUse& use = family.key_use;
  int built = 0;
  for (const Spacing spacing : {Spacing::even, Spacing::uneven}) {
    const Keyframes keys = keyframes(random_walk(31, use.keys_for(6), spacing, step_on(family, spacing, 1.2)));
    for (const Parameter& parameter : family.parameters)
      for (const double wanted : {-100.0, -7.0, 12.0, 100.0}) {
        const double value = std::clamp(wanted, parameter.lowest, parameter.highest);
        SCOPED_TRACE(std::string(parameter.name) + " = " + std::to_string(value));
        CurveOptions options;
        options.parameters.emplace(parameter.name, std::vector{value});
        const auto curve = make_curve({family.name, options}, keys);
        if (!curve) continue;  // some values are none that the family takes on these keys
        ++built;
        EXPECT_TRUE(agree_in_both(*curve, 17));
      }
  }
  EXPECT_TRUE(built > 0 || family.parameters.empty());
}

TEST_P(BatchOfFamily, AgreesOnWideTurns) {
  const FamilyInfo& family = *find_family(GetParam()).value();
  const KeyUse& use = family.key_use;
  for (const double turn : {3.0, 3.14159, 4.5, 6.2}) {
    SCOPED_TRACE(turn);
    const auto curve =
        make_curve(family.name, keyframes(random_walk(37, use.keys_for(6), Spacing::even, std::min(turn, 10.0))));
    if (curve) EXPECT_TRUE(agree_in_both(*curve, 17));
    else EXPECT_EQ(curve.error().code, ErrorCode::not_converged) << describe(curve.error());
  }
}

TEST_P(BatchOfFamily, AgreesAtTimesOfTheClock) {
  const FamilyInfo& family = *find_family(GetParam()).value();
  KeyframeData data =
      random_walk(41, family.key_use.keys_for(6), Spacing::uneven, step_on(family, Spacing::uneven, 0.8));
  for (double& t : data.times) t += 1.7e9;  // [s]: the epoch of 1970, half a microsecond apart at the finest
  const auto curve = make_curve(family.name, keyframes(data));
  ASSERT_TRUE(curve) << describe(curve.error());
  EXPECT_TRUE(agree_in_both(*curve, 17));
}

std::vector<std::string> names_of_families() {
  std::vector<std::string> names;
  for (const FamilyInfo& family : families_info()) names.emplace_back(family.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Every, BatchOfFamily, testing::ValuesIn(names_of_families()), [](const auto& test) {
  std::string name(test.param);
  std::ranges::replace(name, '-', '_');
  return name;
});

template <class T>
double largest_error_of_norm(const AnyCurve& curve) {
  const std::vector<double> times = sample_times(curve.knots().times(), 17);
  Sampled<T> samples(times.size(), Wanted::orientation);
  EXPECT_TRUE(sample<T>(curve, times, samples.spans()));
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double error = std::abs(samples.orientation(i).norm() - 1.0);
    largest = error <= largest ? largest : error;  // NaN counts
  }
  return largest;
}

TEST(Batch, IsOfUnitQuaternionsHoweverOftenASegmentTurns) {
  const Keyframes keys = keyframes(random_walk(44, 6, Spacing::uneven, 1.0));
  for (const double rate : {1e3, 1e5, 1e6, 1e8, 1e12, 1e17}) {
    SCOPED_TRACE(rate);
    const End clamped{.rule = EndRule::clamped, .angular_velocity = {rate, -rate, 0.5 * rate}};
    const auto curve = make_curve({"timed-c1", {.start = clamped, .end = clamped}}, keys);
    ASSERT_TRUE(curve);
    EXPECT_LE(largest_error_of_norm<double>(*curve), 1e-14);
    EXPECT_LE(largest_error_of_norm<float>(*curve), 1e-5);
  }
}

TEST(Batch, GoesThroughTheKernelForFamiliesThatStateTheirSegments) {
  const Keyframes keys = keyframes(random_walk(43, 12, Spacing::even, 0.8));
  const auto is_compiled = [&](const char* family) {
    const CompiledCurve<> compiled(make_curve(family, keys).value());
    return !std::holds_alternative<std::monostate>(*compiled.record(2));
  };
  for (const char* family : {"slerp",      "quintic",         "sextic",       "timed-c1",
                             "timed-c2",   "timed-c3",        "timed-sextic", "hermite-cumulative",
                             "bspline",    "bspline-through", "xing-quartic", "xing-quintic",
                             "auto",       "auto5",           "hermite-c1",   "hermite-c2",
                             "hermite-c3", "rotation-spline", "squad",        "squad-timed"})
    EXPECT_TRUE(is_compiled(family)) << family;
  EXPECT_FALSE(is_compiled("barry-goldman"));
}

}}  // namespace orispline
