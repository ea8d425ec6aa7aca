// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/bake.hpp>

#include <bit>
#include <cstring>

#include <gtest/gtest.h>

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
  EXPECT_EQ(count(document, "pieces"), outcome->baked.curve.pieces().size());
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
  const std::string bytes = baked_bytes(outcome->baked, outcome->request.keys->epoch);
  const std::size_t pieces = outcome->baked.curve.pieces().size();
  ASSERT_EQ(bytes.size(), 32 + 8 * (pieces + 1) + 96 * pieces);
  EXPECT_EQ(bytes.substr(0, 8), "ORIBAKED");
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 8), 1u);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 12), pieces);
  EXPECT_EQ(number_at<double>(bytes, 16), 12.5);
  EXPECT_EQ(number_at<double>(bytes, 24), outcome->baked.curve.largest_difference());
  EXPECT_EQ(number_at<double>(bytes, 32 + 8 * pieces), 2.0);
  const auto& last = outcome->baked.curve.pieces().back();
  EXPECT_EQ(number_at<float>(bytes, bytes.size() - 4), last.coefficients[3][5]);
  EXPECT_EQ(number_at<float>(bytes, bytes.size() - 96), last.coefficients[0][0]);
}

TEST(BakeJob, HoldsASingleKeyAsAPieceWithoutLength) {
  const auto outcome = baked(turns({0.5}), 1e-5);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  EXPECT_NE(baked_json(outcome->baked, outcome->request.keys->epoch).find(R"("ends":[0,0],"pieces":[[0,0,0,0,0,0,)"),
            std::string::npos)
      << baked_json(outcome->baked, outcome->request.keys->epoch);
  EXPECT_EQ(baked_bytes(outcome->baked, outcome->request.keys->epoch).size(), 32u + 16 + 96);
}

/// Orientations with positions on a clock of their own, far from 0.
std::shared_ptr<const Track> far_away() {
  Track track = turns_of({0.0, 1.0, 1.5});
  const Eigen::Vector3d corner(4e5, 5e6, 10.0);
  track.positions_apart = {
      .times = {0.5, 1.0, 1.75, 3.0},
      .positions = {corner, corner + Eigen::Vector3d(1.0, 0.0, 0.5), corner + Eigen::Vector3d(2.0, 1.0, 0.0),
                    corner + Eigen::Vector3d(2.0, 3.0, 0.0)}};
  return std::make_shared<const Track>(std::move(track));
}

TEST(BakeJob, HoldsPositionsWithinTheirTolerance) {
  const std::shared_ptr<const Track> keys = far_away();
  for (const double tolerance : {1e-4, 1e-2}) {
    const auto outcome = bake({.keys = keys,
                               .method = {.method = Method("auto")},
                               .options = {.tolerance = 1e-3, .position_tolerance = tolerance}});
    ASSERT_TRUE(outcome) << describe(outcome.error());
    ASSERT_TRUE(outcome->baked.path);
    EXPECT_TRUE(outcome->warnings.empty());
    const auto curve = shaped_curve(Method("auto"), *keys);
    ASSERT_TRUE(curve && curve->position);
    double largest = 0.0;
    for (double t = 0.0; t < 3.5; t += 1.0 / 1024)
      largest = std::max(largest, ((*outcome->baked.path)(t)-curve->position->linear_motion(t).position).norm());
    EXPECT_LE(largest, tolerance);
    EXPECT_LE(outcome->baked.path->largest_difference(), largest + 1e-9);
    EXPECT_GT(largest, 0.0);
    const Json document = document_of(*outcome);
    EXPECT_EQ(count(document, "position_pieces"), outcome->baked.path->pieces().size());
    EXPECT_EQ(number(document, "position_tolerance_m"), tolerance);
  }
}

TEST(BakeJob, WritesPositionsBehindTheOrientations) {
  const auto outcome = baked(far_away(), 1e-5);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  const std::string bytes = baked_bytes(outcome->baked, outcome->request.keys->epoch);
  const std::size_t second = 40 + 104 * outcome->baked.curve.pieces().size(),
                    pieces = outcome->baked.path->pieces().size();
  ASSERT_EQ(bytes.size(), second + 16 + 8 * (pieces + 1) + 84 * pieces);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 8), 2u);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, second), pieces);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, second + 4), 0u);
  EXPECT_EQ(number_at<double>(bytes, second + 8), outcome->baked.path->largest_difference());
  EXPECT_EQ(number_at<double>(bytes, second + 16), 0.5);
  EXPECT_EQ(number_at<double>(bytes, second + 16 + 8 * pieces), 3.0);
  const auto& front = outcome->baked.path->pieces().front();
  EXPECT_EQ(number_at<double>(bytes, second + 24 + 8 * pieces + 8), front.first[1]);
  EXPECT_EQ(number_at<float>(bytes, second + 24 + 32 * pieces), front.others[0][0]);
  EXPECT_EQ(number_at<float>(bytes, bytes.size() - 4), outcome->baked.path->pieces().back().others[2][4]);
  const std::string json = baked_json(outcome->baked, outcome->request.keys->epoch);
  EXPECT_NE(json.find(R"("version":2)"), std::string::npos);
}

TEST(BakeJob, HoldsPositionsOfASingleKey) {
  Track track = turns_of({0.5});
  track.positions_apart = {.times = {2.0}, .positions = {Eigen::Vector3d(1.0, 2.0, 3.0)}};
  const auto outcome = baked(std::make_shared<const Track>(std::move(track)), 1e-5);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  for (const double t : {-1.0, 2.0, 5.0}) EXPECT_EQ((*outcome->baked.path)(t), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_NE(baked_json(outcome->baked, outcome->request.keys->epoch)
                .find(R"("position_ends":[2,2],"position_pieces":[[1,0,0,0,0,0,2,)"),
            std::string::npos);
}

TEST(BakeJob, KeepsTheMillimetresOfALongWay) {
  Track track = turns_of({0.0, 1.0, 1.5});
  track.positions_apart = {
      .times = {0.0, 1.0, 2.0},
      .positions = {Eigen::Vector3d::Zero(), Eigen::Vector3d(1e6, 0.0, 0.0), Eigen::Vector3d(1e6, 3e5, 0.0)}};
  const auto outcome = baked(std::make_shared<const Track>(std::move(track)), 1e-2);
  ASSERT_TRUE(outcome) << describe(outcome.error());
  EXPECT_LE(outcome->baked.path->largest_difference(), 1e-3);
}

TEST(BakeJob, SaysWhichToleranceOfPositionsIsMissed) {
  Track track = turns_of({0.0, 1.0});
  track.positions_apart = {.times = {0.0, 1.0},
                           .positions = {Eigen::Vector3d::Zero(), Eigen::Vector3d(1e15, 0.0, 0.0)}};
  const auto outcome = baked(std::make_shared<const Track>(std::move(track)), 1e-2);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().option, "position_tolerance");
  EXPECT_NE(outcome.error().message.find(" m, wanted 0.001: ask for "), std::string::npos) << outcome.error().message;
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
