// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/measure_info.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <orispline/analysis/compared_keys.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { namespace {

const MeasureInfo& measure_of(std::string_view id) { return *std::ranges::find(measures_info(), id, &MeasureInfo::id); }

Continuity jumping(int order) {
  RateJump jump{.largest = 1.0, .magnitude = 1.0, .relative = 1.0};
  Continuity continuity;
  if (order < 1) continuity.angular_velocity = jump;
  if (order < 2) continuity.angular_acceleration = jump;
  return continuity;
}

TEST(MeasureInfo, IsToldApartByIdWordAndHeading) {
  for (const auto member : {&MeasureInfo::id, &MeasureInfo::word, &MeasureInfo::heading}) {
    std::set<std::string_view> seen;
    for (const MeasureInfo& measure : measures_info())
      EXPECT_TRUE((measure.*member).empty() || seen.insert(measure.*member).second) << measure.id;
  }
}

TEST(MeasureInfo, IsWholeEverywhere) {
  for (const MeasureInfo& measure : measures_info()) {
    EXPECT_FALSE(measure.id.empty() || measure.label.empty() || measure.explanation.empty()) << measure.id;
    EXPECT_TRUE(measure.value) << measure.id;
    EXPECT_TRUE(measure.word.empty() || measure.better != Better::neither) << measure.id << ": no order to sort by";
  }
}

TEST(MeasureInfo, KnowsItsMomentsAndThatAnglesOfEqualOrientationsAreRoundingErrors) {
  for (const MeasureInfo& measure : measures_info()) {
    EXPECT_EQ(measure.is_time, measure.id.ends_with("_at_s")) << measure.id;
    EXPECT_EQ(measure.rounding > 0.0, !measure.unit.empty() && measure.unit != "s") << measure.id;
  }
  EXPECT_GT(measure_of("max_deg").rounding, 1.38e-33);
  EXPECT_LT(measure_of("max_deg").rounding, 1e-9);
}

TEST(MeasureInfo, GroupsKeepTheOrderOfTheListWhateverTheirs) {
  const auto some = measures_of({MeasureGroup::cost, MeasureGroup::distance});
  EXPECT_EQ(some.front().id, "rms_deg");
  EXPECT_EQ(some.back().id, "seconds");
  EXPECT_TRUE(std::ranges::none_of(some, [](const MeasureInfo& m) { return m.group == MeasureGroup::shape; }));
}

TEST(MeasureInfo, GivesValuesInItsUnitAndTimesInTheFilesOwn) {
  const Measures measures{.distance = {.rms = 0.5, .largest = 1.0, .largest_at = 2}};
  const std::vector<double> times{0.0, 0.25, 0.5};
  const MeasureTimes told_by{Decimal::from_double(100.0), times};
  EXPECT_EQ(measure_of("rms_deg").value(measures, told_by), 0.5 * degrees);
  EXPECT_EQ(measure_of("spherical_rms_rad").value(measures, told_by), 0.25);
  EXPECT_EQ(measure_of("mse_rad2").value(measures, told_by), 0.25);
  EXPECT_EQ(measure_of("max_at_s").value(measures, told_by), 100.5);
  EXPECT_EQ(measure_of("rate_rms_rad_s").value(measures, told_by), std::nullopt);
  EXPECT_EQ(measure_of("leave_out_rms_deg").value(measures, told_by), std::nullopt);
}

TEST(MeasureInfo, AnEnergyIsInfiniteWhereARateThatItIntegratesJumps) {
  EXPECT_FALSE(measure_of("energy").is_finite({.continuity = jumping(0)}));
  EXPECT_TRUE(measure_of("energy").is_finite({.continuity = jumping(1)}));
  EXPECT_FALSE(measure_of("jerk_energy").is_finite({.continuity = jumping(1)}));
  EXPECT_TRUE(measure_of("jerk_energy").is_finite({.continuity = jumping(2)}));
  EXPECT_TRUE(measure_of("rms_deg").is_finite({.continuity = jumping(0)}));
}

TEST(ComparedMethods, AreSortedInEachSetOfKeysWithTheFailedOnesLast) {
  const auto method = [](std::string label, std::size_t key_set, double energy, int order) {
    ComparedMethod compared{.label = std::move(label), .key_set = key_set, .candidate = {}};
    compared.measures = Measures{.continuity = jumping(order), .energies = {.acceleration = energy}};
    return compared;
  };
  std::vector methods{method("other set", 1, 0.0, 2), method("jumps", 0, 0.5, 0), method("more", 0, 3.0, 2),
                      method("less", 0, 2.0, 2)};
  methods.push_back({.label = "failed", .candidate = {}, .measures = failure(ErrorCode::bad_data, "why")});
  sort_by(measure_of("energy"), methods, {});
  std::vector<std::string> labels;
  for (const ComparedMethod& compared : methods) labels.push_back(compared.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"less", "more", "jumps", "failed", "other set"}));
  sort_by(measure_of("continuity"), methods, {});
  EXPECT_EQ(methods[2].label, "jumps");
}

}}  // namespace orispline
