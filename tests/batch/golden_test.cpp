// SPDX-License-Identifier: Apache-2.0
// Samples in bulk, and of baked curves, against the scalar evaluator on every case of tests/data/golden.
#include <batch/agreement.hpp>
#include <batch/baked_rates.hpp>
#include <support/golden_case.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr std::size_t golden_samples_per_segment = 23;  // not a multiple of any vector's length

void expect_agreement(const AnyCurve& curve) {
  const std::vector<double> times = sample_times(curve.knots().times(), golden_samples_per_segment);
  EXPECT_TRUE(agree<double>(curve, times));
  EXPECT_TRUE(agree<float>(curve, times));
}

TEST(BatchOnGoldenCases, AgreesWithTheScalarEvaluator) {
  const DataTable keys("golden/keys.csv"), cases("golden/cases.csv");
  ASSERT_EQ(cases.size(), 821u);

  for (const auto& golden_case : cases.rows()) {
    SCOPED_TRACE(label_of(golden_case));
    const auto curve = make_curve({golden_case.text("family"), options_of(golden_case)}, keys_of(keys, golden_case));
    ASSERT_TRUE(curve) << describe(curve.error());
    expect_agreement(*curve);
  }
}

TEST(BatchOnGoldenCases, HasTheRatesOfTheCurveWhenBaked) {
  const DataTable keys("golden/keys.csv"), cases("golden/cases.csv");
  for (const auto& golden_case : cases.rows()) {
    SCOPED_TRACE(label_of(golden_case));
    const AnyCurve curve =
        make_curve({golden_case.text("family"), options_of(golden_case)}, keys_of(keys, golden_case)).value();
    const Eigen::Array3d found = largest_rate_differences<double>(curve, 1e-9);
    EXPECT_TRUE((found <= allowed_rate_differences<double>()).all()) << found.transpose();
  }
}

TEST(BatchOnGoldenCases, AgreesWithTheScalarEvaluatorForAuto) {
  const DataTable keys("golden/auto_keys.csv");
  std::map<std::string, KeyframeData> sequences;
  for (const auto& key : keys.rows()) {
    KeyframeData& data = sequences[key.text("sequence")];
    data.times.push_back(key.number("t"));
    data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
  }
  ASSERT_EQ(sequences.size(), 17u);

  for (const auto& [name, data] : sequences) {
    for (const char* family : {"auto", "auto5"}) {
      SCOPED_TRACE(name + ", " + family);
      expect_agreement(make_curve(family, keyframes(data, Signs::shortest)).value());
    }
  }
}

}}  // namespace orispline
