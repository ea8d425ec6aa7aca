// SPDX-License-Identifier: Apache-2.0
// Samples in bulk of a curve whose keys arrive one by one are those of the curve through all of them: to the last bit.
#include <limits>

#include <gtest/gtest.h>

#include <online/online_stream.hpp>
#include <orispline/batch/sample.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/online/online_curve.hpp>
#include <support/not_finite.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Room for a sample of everything.
struct Rows {
  explicit Rows(std::size_t count) : orientations(4 * count) { rest.fill(std::vector<double>(3 * count)); }
  [[nodiscard]] Samples<double> spans() {
    return {.orientations = orientations,
            .angular_velocities = rest[0],
            .angular_accelerations = rest[1],
            .angular_jerks = rest[2],
            .positions = rest[3],
            .velocities = rest[4],
            .accelerations = rest[5],
            .linear_jerks = rest[6]};
  }
  bool operator==(const Rows&) const = default;

  std::vector<double> orientations;
  std::array<std::vector<double>, 7> rest;
};

class SamplesOfEveryOnlineMethod : public testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(Methods, SamplesOfEveryOnlineMethod, testing::ValuesIn(OnlineCurve::methods()),
                         [](const auto& test) {
                           std::string name(test.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(SamplesOfEveryOnlineMethod, HaveTheBitsOfTheWholeCurveInAnyOrder) {
  OnlineCurve online = OnlineCurve::make(GetParam(), 300).value();
  const FinalKeys final_keys(GetParam(), online);
  const std::size_t count = final_keys.use.cut(120);
  const KeyframeData data = raw_walk(511, count);
  const PoseCurve offline = make_pose_curve(GetParam(), keyframes(data, Signs::shortest)).value();
  Dice dice(512);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(append(online, data, i, i + 1));
    if (i + 1 == count) {
      ASSERT_TRUE(online.finish());
    }
    if (i % 40 != 39 && i + 1 != count) continue;
    const auto [start, end] = online.available().value();
    std::vector<double> times{start};
    for (int k = 0; k < 200; ++k) times.push_back(dice.between(start, end));
    for (int k = 0; k < 200; ++k) times.push_back(start + (end - start) * k / 200.0);
    if (i + 1 == count) times.insert(times.end(), {end, end + 1.0, start - 1.0});
    Rows found(times.size()), wanted(times.size());
    ASSERT_TRUE(online.sample(times, found.spans()));
    ASSERT_TRUE(sample_at<double>(offline, times, wanted.spans()));
    EXPECT_TRUE(found == wanted) << "after key " << i;
  }
}

TEST(OnlineSamples, AreNotANumberWithoutKeysAndTheFirstKeyBeforeASegmentIsFinal) {
  OnlineCurve online = OnlineCurve::make("timed-c2", 4).value();
  const std::vector<double> times{0.5, nan};
  std::vector<double> orientations(8), velocities(6), positions(6);
  const Samples<double> turning{.orientations = orientations, .angular_velocities = velocities};
  ASSERT_TRUE(online.sample(times, turning));
  for (const double number : orientations) EXPECT_TRUE(std::isnan(number));
  const Eigen::Quaterniond first = exp<double>(Eigen::Vector3d(0.1, 0.2, 0.3));
  ASSERT_TRUE(online.append(0.0, first, {1.0, 2.0, 3.0}));
  Samples<double> moving = turning;
  moving.positions = positions;
  ASSERT_TRUE(online.sample(times, moving));
  EXPECT_EQ(Eigen::Vector4d(orientations.data()), online(0.5).coeffs());
  EXPECT_EQ(Eigen::Vector3d(velocities.data()), Eigen::Vector3d::Zero());
  EXPECT_EQ(Eigen::Vector3d(positions.data()), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_TRUE(std::isnan(orientations[4]) && std::isnan(velocities[3]) && std::isnan(positions[3]));
}

TEST(OnlineSamples, RefuseRoomThatDoesNotFit) {
  OnlineCurve online = OnlineCurve::make("slerp", 4).value();
  ASSERT_TRUE(online.append(0.0, Eigen::Quaterniond::Identity()));
  std::vector<double> orientations(8), positions(6);
  EXPECT_FALSE(online.sample(std::vector{0.0}, {.orientations = orientations}));
  const auto without = online.sample(std::vector{0.0, 1.0}, {.orientations = orientations, .positions = positions});
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().message, "found room for positions, wanted none: the keys have no positions");
}

}}  // namespace orispline
