// SPDX-License-Identifier: Apache-2.0
// Samples outside a curve, written over those that were held.
#include <orispline/batch/sample.hpp>

#include <vector>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/not_finite.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Room for everything of so many samples.
template <class T>
struct Everything {
  explicit Everything(std::size_t count) : columns(8, std::vector<T>(4 * count)), size(count) {}

  [[nodiscard]] Samples<T> spans(Layout layout = Layout::interleaved) {
    const auto three = [this](std::size_t i) { return std::span<T>(columns[i]).first(3 * size); };
    return {.orientations = columns[0],
            .angular_velocities = three(1),
            .angular_accelerations = three(2),
            .angular_jerks = three(3),
            .positions = three(4),
            .velocities = three(5),
            .accelerations = three(6),
            .linear_jerks = three(7),
            .layout = layout};
  }
  [[nodiscard]] Eigen::Vector3d vector(std::size_t column, std::size_t sample, Layout layout) const {
    const std::size_t first = layout == Layout::planar ? sample : 3 * sample,
                      next = layout == Layout::planar ? size : 1;
    const auto& c = columns[column];
    return Eigen::Matrix<T, 3, 1>(c[first], c[first + next], c[first + 2 * next]).template cast<double>();
  }

  std::vector<std::vector<T>> columns;
  std::size_t size;
};

PoseCurve some_curve(std::string_view method = "timed-c2") {
  return make_pose_curve(std::string(method), keyframes(posed_walk(91, 6, Spacing::uneven))).value();
}

/// Inside and outside by turns, in no order.
std::vector<double> times_about(const PoseCurve& curve, std::size_t count) {
  const auto [start, end] = curve.orientation.domain();
  Dice dice(92);
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k) times.push_back(dice.between(start - 1.0, end + 1.0));
  times[count / 2] = nan;
  return times;
}

TEST(Extrapolate, WritesWhatIsOutsideAndNothingElse) {
  for (const char* method : {"timed-c2", "auto", "squad-timed"})
    for (const Extrapolation how : {Extrapolation::nan, Extrapolation::rate, Extrapolation::segment})
      for (const Layout layout : {Layout::interleaved, Layout::planar}) {
        const PoseCurve curve = some_curve(method);
        const std::vector<double> times = times_about(curve, 300);
        Everything<double> held(times.size());
        ASSERT_TRUE(sample_at<double>(curve, times, held.spans(layout)));
        Everything<double> samples = held;
        ASSERT_TRUE(extrapolate<double>(curve, times, how, samples.spans(layout)));
        for (std::size_t k = 0; k < times.size(); ++k) {
          const bool is_outside = !std::isnan(times[k]) && !curve.orientation.domain().contains(times[k]);
          const Motion motion = extrapolated(curve.orientation, times[k], how);
          const LinearMotion linear = extrapolated(*curve.position, times[k], how);
          const std::array wanted{
              motion.angular_velocity, motion.angular_acceleration, motion.angular_jerk, linear.position,
              linear.velocity,         linear.acceleration,         linear.jerk};
          for (std::size_t column = 1; column < 8; ++column) {
            const Eigen::Vector3d found = samples.vector(column, k, layout),
                                  want = is_outside ? wanted[column - 1] : held.vector(column, k, layout);
            EXPECT_TRUE(found == want || (found.hasNaN() && want.hasNaN())) << method << ' ' << column << ' ' << k;
          }
        }
      }
}

TEST(Extrapolate, HasTheSameSamplesOnAnyNumberOfThreadsAndInSinglePrecision) {
  const PoseCurve curve = some_curve();
  const std::vector<double> times = times_about(curve, 20000);
  Everything<double> alone(times.size()), together(times.size());
  Everything<float> single(times.size());
  for (auto [samples, threads] : {std::pair{&alone, 1U}, std::pair{&together, 3U}}) {
    ASSERT_TRUE(sample_at<double>(curve, times, samples->spans()));
    ASSERT_TRUE(extrapolate<double>(curve, times, Extrapolation::segment, samples->spans(), {.threads = threads}));
  }
  ASSERT_TRUE(sample_at<float>(curve, times, single.spans()));
  ASSERT_TRUE(extrapolate<float>(curve, times, Extrapolation::segment, single.spans()));
  for (std::size_t k = 0; k < 4 * times.size(); ++k) {
    if (std::isnan(alone.columns[0][k])) continue;
    ASSERT_EQ(alone.columns[0][k], together.columns[0][k]);
    ASSERT_NEAR(alone.columns[0][k], single.columns[0][k], 1e-6);
  }
}

TEST(Extrapolate, NamesTheFirstTimeOutsideWhereThatIsAnError) {
  const PoseCurve curve = some_curve();
  const auto [start, end] = curve.orientation.domain();
  const std::vector<double> times{start, nan, end, end + 0.5, start - 1.0};
  Everything<double> samples(times.size());
  const auto done = extrapolate<double>(curve, times, Extrapolation::error, samples.spans());
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(done.error().where.time_index, 3u);
  EXPECT_NE(done.error().message.find("is outside the curve, wanted"), std::string::npos);
  EXPECT_TRUE(check_inside(curve.orientation, std::span(times).first(3)));
  EXPECT_TRUE(extrapolate<double>(curve, times, Extrapolation::hold, samples.spans()));
}

TEST(Extrapolate, RefusesRoomThatDoesNotFit) {
  const PoseCurve curve = some_curve(), turning{.orientation = curve.orientation};
  const std::vector<double> times{0.0, 1.0, 2.0};
  Everything<double> four(4), three(3);
  EXPECT_FALSE(extrapolate<double>(curve, times, Extrapolation::rate, four.spans()));
  const auto without = extrapolate<double>(turning, times, Extrapolation::rate, three.spans());
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().message, "found room for positions, wanted none: the keys of the curve have no positions");
}

}}  // namespace orispline
