// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/bake.hpp>

#include <bit>
#include <cstring>

#include <gtest/gtest.h>

#include <orispline/jobs/baked_file.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

Expected<BakeOutcome> baked(std::shared_ptr<const Track> keys, double tolerance, const std::string& method = "auto") {
  return bake({.keys = std::move(keys), .method = {.method = Method(method)}, .options = {.tolerance = tolerance}});
}

/// A number of the little-endian file.
template <class Number>
Number number_at(const std::string& bytes, std::size_t place) {
  static_assert(std::endian::native == std::endian::little);
  Number number;
  std::memcpy(&number, bytes.data() + place, sizeof(number));
  return number;
}

TEST(BakeJob, SaysTheSameInItsDocumentAndItsSummary) {
  const auto outcome = baked(turns({0.0, 1.0, 1.5}), 1e-5);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  const Json document = document_of(*outcome);
  EXPECT_EQ(count(document, "pieces"), outcome->curve.pieces().size());
  EXPECT_LE(number(document, "largest_difference_rad"), 1e-5);
  const std::string summary = summary_of(*outcome);
  EXPECT_TRUE(summary.starts_with("3 keys from data/arm.csv, auto: ")) << summary;
  EXPECT_NE(summary.find("within 0.000573°"), std::string::npos) << summary;
}

TEST(BakeJob, WritesWhatTheCurveHoldsAsBytes) {
  Track track = turns_of({0.0, 1.0, 1.5});
  track.epoch = Decimal::from_double(12.5);
  const auto outcome = baked(std::make_shared<const Track>(std::move(track)), 1e-5);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  const std::string bytes = baked_bytes(*outcome);
  const std::size_t pieces = outcome->curve.pieces().size();
  ASSERT_EQ(bytes.size(), 32 + 8 * (pieces + 1) + 96 * pieces);
  EXPECT_EQ(bytes.substr(0, 8), "ORIBAKED");
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 8), 1u);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 12), pieces);
  EXPECT_EQ(number_at<double>(bytes, 16), 12.5);
  EXPECT_EQ(number_at<double>(bytes, 24), outcome->curve.largest_difference());
  EXPECT_EQ(number_at<double>(bytes, 32 + 8 * pieces), 2.0);
  const auto& last = outcome->curve.pieces().back();
  EXPECT_EQ(number_at<float>(bytes, bytes.size() - 4), last.coefficients[3][5]);
  EXPECT_EQ(number_at<float>(bytes, bytes.size() - 96), last.coefficients[0][0]);
}

TEST(BakeJob, HoldsASingleKeyAsAPieceWithoutLength) {
  const auto outcome = baked(turns({0.5}), 1e-5);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  EXPECT_NE(baked_json(*outcome).find(R"("ends":[0,0],"pieces":[[0,0,0,0,0,0,)"), std::string::npos)
      << baked_json(*outcome);
  EXPECT_EQ(baked_bytes(*outcome).size(), 32u + 16 + 96);
}

TEST(BakeJob, WarnsThatPositionsAreLeftOut) {
  Track track = turns_of({0.0, 1.0});
  track.positions_apart = {.times = {0.0, 1.0}, .positions = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}};
  const auto outcome = baked(std::make_shared<const Track>(std::move(track)), 1e-5);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  ASSERT_EQ(outcome->warnings.size(), 1u);
  EXPECT_EQ(outcome->warnings[0].code, "positions_left_out");
}

TEST(BakeJob, RefusesWhatFloatCannotHold) {
  for (const double tolerance : {0.0, 1e-7, -1.0}) {
    const auto outcome = baked(turns({0.0, 1.0}), tolerance);
    ASSERT_FALSE(outcome) << tolerance;
    EXPECT_EQ(outcome.error().option, "tolerance");
    EXPECT_NE(outcome.error().message.find("1e-06 rad"), std::string::npos) << outcome.error().message;
  }
}

TEST(BakeJob, SaysWhatIsReachedWhereTheToleranceIsNot) {
  // Keys so near to each other that the curve flies about between the others.
  const auto keys = turns_of({0.0, 1.0, 2.0, 1.0, 0.0}).with_times({0.0, 1.0, 1.0 + 1e-9, 2.0, 3.0});
  const auto outcome = baked(std::make_shared<const Track>(*keys), 1e-6, "timed-c2");
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().option, "tolerance");
  EXPECT_TRUE(outcome.error().where.key);
  EXPECT_NE(outcome.error().message.find(
                " rad, wanted 1e-06: ask for a much larger tolerance, or a curve that turns less there"),
            std::string::npos)
      << outcome.error().message;
}

TEST(BakeJob, RefusesGaps) {
  Track track = turns_of({0.0, 1.0, 1.5});
  track.recipe.gap = 0.5;
  const auto outcome = baked(std::make_shared<const Track>(std::move(track)), 1e-5);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().option, "gap");
}

}}  // namespace orispline::jobs
