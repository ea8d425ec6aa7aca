// SPDX-License-Identifier: Apache-2.0
// Which times may be asked for, and what the answers are.
#include <cmath>

#include <batch/agreement.hpp>
#include <batch/specimen_curves.hpp>
#include <support/not_finite.hpp>

namespace orispline { namespace {

using namespace testing_support;

class BatchTimes : public testing::TestWithParam<const char*> {
 protected:
  const AnyCurve curve_ = specimen_curve(GetParam());
  const double start_ = curve_.domain().start, end_ = curve_.domain().end;

  /// The sample at an end: what is held has its bits.
  Eigen::Quaterniond sample_at_end(double t) const {
    Sampled<double> end(1, Wanted::orientation);
    EXPECT_TRUE(sample<double>(curve_, {&t, 1}, end.spans()));
    EXPECT_LE((end.orientation(0) - curve_(t).coeffs()).norm(), 1e-14);
    return Eigen::Quaterniond(end.orientation(0));
  }

  static void expect_at_rest(const Sampled<double>& samples, std::size_t i, const Eigen::Quaterniond& q) {
    EXPECT_EQ(samples.orientation(i), q.coeffs()) << "sample " << i;
    EXPECT_EQ(samples.velocity(i), Eigen::Vector3d::Zero()) << "sample " << i;
    EXPECT_EQ(samples.acceleration(i), Eigen::Vector3d::Zero()) << "sample " << i;
    EXPECT_EQ(samples.jerk(i), Eigen::Vector3d::Zero()) << "sample " << i;
  }
};

TEST_P(BatchTimes, OutsideTheDomainHoldTheEndsAtRest) {
  const std::vector<double> times{
      -infinity, start_ - 5.0, std::nextafter(start_, -infinity), std::nextafter(end_, infinity), end_ + 5.0, infinity};
  Sampled<double> samples(times.size(), Wanted::jerk);
  ASSERT_TRUE(sample<double>(curve_, times, samples.spans()));
  for (std::size_t i = 0; i < 3; ++i) expect_at_rest(samples, i, sample_at_end(start_));
  for (std::size_t i = 3; i < 6; ++i) expect_at_rest(samples, i, sample_at_end(end_));
}

TEST_P(BatchTimes, AtTheFirstAndTheLastKnotAreInMotion) {
  const std::vector<double> times{start_, end_, end_};
  Sampled<double> samples(times.size(), Wanted::jerk);
  ASSERT_TRUE(sample<double>(curve_, times, samples.spans()));
  EXPECT_TRUE(agree(samples, curve_, times, Wanted::jerk));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GT(samples.velocity(i).norm(), 0.1) << i;
}

TEST_P(BatchTimes, AtAndBesideKnotsBelongToTheRightSegment) {
  std::vector<double> times;
  for (const double knot : curve_.knots().times().subspan(1, curve_.knots().segments() - 1))
    times.insert(times.end(), {std::nextafter(knot, -infinity), knot, knot, std::nextafter(knot, infinity)});
  EXPECT_TRUE(agree<double>(curve_, times));
}

TEST_P(BatchTimes, ThatAreNoNumbersGiveNone) {
  const double middle = 0.5 * (start_ + end_);
  const std::vector<double> times{nan, start_ - 1.0, nan, start_, middle, nan, nan, middle, end_, end_, infinity, nan};
  Sampled<double> samples(times.size(), Wanted::jerk);
  ASSERT_TRUE(sample<double>(curve_, times, samples.spans()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (std::isnan(times[i])) {
      EXPECT_TRUE(samples.orientation(i).array().isNaN().all()) << i;
      EXPECT_TRUE(samples.velocity(i).array().isNaN().all()) << i;
      EXPECT_TRUE(samples.acceleration(i).array().isNaN().all()) << i;
      EXPECT_TRUE(samples.jerk(i).array().isNaN().all()) << i;
    } else {
      const Motion m = curve_.motion(times[i]);
      EXPECT_LE((samples.orientation(i) - m.orientation.coeffs()).norm(), 1e-14) << i;
      EXPECT_LE((samples.velocity(i) - m.angular_velocity).norm(), 1e-13 * (1.0 + m.angular_velocity.norm())) << i;
    }
  }
}

TEST_P(BatchTimes, ThatAreEvenMayStartBeforeAndEndAfterTheCurve) {
  const double dt = (end_ - start_) / 301.0, t0 = start_ - 20.0 * dt;
  Sampled<double> samples(350, Wanted::jerk);
  ASSERT_TRUE(sample_uniform<double>(curve_, t0, dt, samples.spans()));
  std::vector<double> times;
  for (int k = 0; k < 350; ++k) times.push_back(k * dt + t0);
  EXPECT_TRUE(agree(samples, curve_, times, Wanted::jerk));
  expect_at_rest(samples, 0, sample_at_end(start_));
  expect_at_rest(samples, 349, sample_at_end(end_));
}

TEST_P(BatchTimes, ThatAreEvenMayStandStill) {
  for (const double t : {start_ - 1.0, start_, 0.3 * start_ + 0.7 * end_, end_, end_ + 1.0}) {
    Sampled<double> samples(5, Wanted::jerk);
    ASSERT_TRUE(sample_uniform<double>(curve_, t, 0.0, samples.spans()));
    EXPECT_TRUE(agree(samples, curve_, std::vector(5, t), Wanted::jerk));
  }
}

TEST_P(BatchTimes, ThatAreEvenMayBeHugeOrTiny) {
  for (const double dt : {1e-300, 1e-17, 1e-9, 1e9, 1e300}) {
    Sampled<double> samples(70, Wanted::velocity);
    ASSERT_TRUE(sample_uniform<double>(curve_, start_, dt, samples.spans()));
    std::vector<double> times;
    for (int k = 0; k < 70; ++k) times.push_back(k * dt + start_);
    EXPECT_TRUE(agree(samples, curve_, times, Wanted::velocity)) << dt;
  }
}

TEST_P(BatchTimes, ThatStartNowhereAreAnsweredAsOneTimeIs) {
  Sampled<double> samples(3, Wanted::jerk);
  ASSERT_TRUE(sample_uniform<double>(curve_, -infinity, 1.0, samples.spans()));
  expect_at_rest(samples, 2, sample_at_end(start_));
  ASSERT_TRUE(sample_uniform<double>(curve_, infinity, 1.0, samples.spans()));
  expect_at_rest(samples, 2, sample_at_end(end_));
  ASSERT_TRUE(sample_uniform<double>(curve_, nan, 1.0, samples.spans()));
  EXPECT_TRUE(samples.orientation(2).array().isNaN().all());
  EXPECT_TRUE(samples.jerk(2).array().isNaN().all());
}

INSTANTIATE_TEST_SUITE_P(Kinds, BatchTimes, testing::ValuesIn(kinds_of_curves),
                         [](const auto& test) { return "kind_" + std::to_string(test.index); });

TEST(BatchTimesOfOneKey, AreAllAnsweredByIt) {
  const KeyframeData data = random_walk(61, 1, Spacing::even);
  const double t = data.times.front();
  const AnyCurve curve = make_curve("timed-c2", keyframes(data)).value();
  const CompiledCurve<> compiled(curve);
  const std::vector<double> times{t, t, t + 1.0, t + 2.0};
  const auto expect_the_key = [&](auto take) {
    Sampled<double> samples(4, Wanted::jerk);
    ASSERT_TRUE(take(samples.spans()));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(samples.orientation(i), data.orientations.front().coeffs());
      EXPECT_EQ(samples.velocity(i), Eigen::Vector3d::Zero());
      EXPECT_EQ(samples.acceleration(i), Eigen::Vector3d::Zero());
      EXPECT_EQ(samples.jerk(i), Eigen::Vector3d::Zero());
    }
  };
  expect_the_key([&](const auto& out) { return sample<double>(curve, times, out); });
  expect_the_key([&](const auto& out) { return sample<double>(compiled, times, out); });
  expect_the_key([&](const auto& out) { return sample_at<double>(compiled, times, out); });
  for (const double dt : {0.0, 1.0}) {
    expect_the_key([&](const auto& out) { return sample_uniform<double>(curve, t, dt, out); });
    expect_the_key([&](const auto& out) { return sample_uniform<double>(compiled, t, dt, out); });
  }
  EXPECT_EQ(compiled(t).coeffs(), data.orientations.front().coeffs());
}

}}  // namespace orispline
