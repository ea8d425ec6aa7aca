// SPDX-License-Identifier: Apache-2.0
// The least energies, as SciPy finds them with the curves of the reference: golden/tuned.csv.
#include <gtest/gtest.h>

#include <orispline/tune/tune.hpp>
#include <support/data_table.hpp>
#include <support/golden_case.hpp>

namespace orispline { namespace {

using testing_support::DataTable;
using testing_support::named_texts;
using Values = std::map<std::string, std::vector<double>, std::less<>>;

Values values_of(const std::string& text) {
  Values values;
  for (const auto& [name, list] : named_texts(text))
    for (const std::string& value : testing_support::fields_of(list, ' '))
      values[name].push_back(testing_support::number_of(value));
  return values;
}

Keyframes keys_named(const DataTable& keys, std::string_view sequence) {
  KeyframeData data;
  for (const auto& key : keys.rows_where("sequence", sequence)) {
    data.times.push_back(key.number("t"));
    data.orientations.push_back(key.quaternion("qw", "qx", "qy", "qz"));
  }
  return Keyframes::make(std::move(data), Signs::shortest).value();
}

Expected<Tuning> tuned_as(const DataTable::Row& row, const Keyframes& keys) {
  TuneOptions options{.objective = row.text("objective") == "torque" ? Objective::torque : Objective::acceleration,
                      .inertia = Eigen::Vector3d(1.0, 2.0, 2.5).asDiagonal(),
                      .parameters = testing_support::fields_of(row.text("free"), ' ')};
  return tune(keys, Method{row.text("family"), {.parameters = values_of(row.text("initial"))}}, options);
}

TEST(TunedGolden, EnergiesAreThoseOfTheReference) {
  const DataTable keys("golden/keys.csv"), table("golden/tuned.csv");
  ASSERT_EQ(table.size(), 19u);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const DataTable::Row row = table.row(i);
    const std::string what = row.text("family") + " " + row.text("sequence") + " " + row.text("objective");
    const auto found = tuned_as(row, keys_named(keys, row.text("sequence")));
    ASSERT_TRUE(found) << what << ": " << describe(found.error());
    EXPECT_NEAR(found->energy_before / row.number("before"), 1.0, 1e-10) << what;
    EXPECT_NEAR(found->energy_after / row.number("after"), 1.0, 1e-9) << what;
    EXPECT_LE(found->stationarity, 1e-8) << what;
  }
}

}}  // namespace orispline
