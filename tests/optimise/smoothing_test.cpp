// SPDX-License-Identifier: Apache-2.0
// What smoothing promises beside the golden cases: invariance, figures that follow from theory, outliers, gaps, a gyro.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/math/so3.hpp>
#include <orispline/optimise/smooth.hpp>
#include <orispline/optimise/smoothing_element.hpp>
#include <orispline/optimise/smoothing_loss.hpp>
#include <orispline/optimise/smoothing_noise.hpp>
#include <orispline/optimise/smoothing_trace.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline::optimise {
namespace {

using testing_support::Dice;
using testing_support::relative_error;

constexpr double degree = 0.017453292519943295;

/// Nearly normal: the sum of twelve uniform variables in [-½, ½].
Eigen::Vector3d normal_vector(Dice& dice) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 12; ++k) sum += 0.5 * dice.vector();
  return sum;
}

struct Recording {
  KeyframeData clean{}, noisy{};
};

/// Turns about two axes at 100 Hz with noise of σ per axis.
Recording recorded(std::size_t count, double noise) {
  Recording recording;
  Dice dice(7);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    const Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.0, 0.0, std::sin(2.0 * t))) *
                                 exp<double>(Eigen::Vector3d(std::sin(3.0 * t), 0.0, 0.0));
    recording.clean.times.push_back(t);
    recording.clean.orientations.push_back(q);
    recording.noisy.orientations.push_back(q * exp<double>(Eigen::Vector3d(noise * normal_vector(dice))));
  }
  recording.noisy.times = recording.clean.times;
  return recording;
}

double rms(const Smoothing& smoothing, const KeyframeData& clean) {
  double sum = 0.0;
  for (std::size_t k = 0; k < smoothing.keys.size(); ++k) {
    const double d = angular_distance(smoothing.nodes.orientations[k], clean.orientations[smoothing.keys[k]]);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(smoothing.keys.size()));
}

SmoothingProblem problem_of(const KeyframeData& data, double noise) {
  return {.times = data.times,
          .orientations = data.orientations,
          .weights = std::vector<double>(data.times.size(), 1.0 / (noise * noise))};
}

class EveryPenalty : public testing::TestWithParam<Penalty> {};

TEST_P(EveryPenalty, IsInvariantUnderRotationsOfWorldAndBodyAndReversal) {
  const double noise = 2.0 * degree;
  const auto data = recorded(60, noise).noisy;
  const SmoothingObjective objective{.penalty = GetParam(), .lambda = lambda_of(0.03, GetParam(), noise, 0.01)};
  const auto fit = fit_smoothing(problem_of(data, noise), objective);
  const Eigen::Quaterniond world = exp<double>(Eigen::Vector3d(0.3, -2.0, 1.0)),
                           body = exp<double>(Eigen::Vector3d(1.0, 0.5, -0.7));
  KeyframeData turned = data, reversed = data;
  for (Eigen::Quaterniond& q : turned.orientations) q = world * q * body;
  std::ranges::reverse(reversed.orientations);
  for (std::size_t i = 0; i < data.times.size(); ++i) reversed.times[i] = -data.times[data.times.size() - 1 - i];
  const auto turned_fit = fit_smoothing(problem_of(turned, noise), objective);
  const auto reversed_fit = fit_smoothing(problem_of(reversed, noise), objective);
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    EXPECT_LT(angular_distance(turned_fit.nodes.orientations[i], world * fit.nodes.orientations[i] * body), 1e-9);
    EXPECT_LT(relative_error(turned_fit.nodes.angular_velocities[i], to_body(body, fit.nodes.angular_velocities[i])),
              1e-8);
    const std::size_t j = data.times.size() - 1 - i;
    EXPECT_LT(angular_distance(reversed_fit.nodes.orientations[j], fit.nodes.orientations[i]), 1e-9);
    EXPECT_LT(
        relative_error(Eigen::Vector3d(-reversed_fit.nodes.angular_velocities[j]), fit.nodes.angular_velocities[i]),
        1e-8);
  }
}

TEST_P(EveryPenalty, KeepsWhatThePenaltyDoesNotSee) {
  KeyframeData steady;
  for (int i = 0; i < 40; ++i) {
    steady.times.push_back(0.1 * i);
    steady.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.02 * i, 0.0)));
  }
  const auto fit = fit_smoothing(problem_of(steady, degree), {.penalty = GetParam(), .lambda = 1e4});
  for (std::size_t i = 0; i < steady.times.size(); ++i) {
    EXPECT_LT(angular_distance(fit.nodes.orientations[i], steady.orientations[i]), 1e-11);
    EXPECT_LT((fit.nodes.angular_velocities[i] - Eigen::Vector3d(0.0, 0.2, 0.0)).norm(), 1e-9);
  }
}

TEST_P(EveryPenalty, FindsTheSameMinimumFromAFitUnderAnotherLambda) {
  const double noise = 3.0 * degree;
  const auto data = recorded(300, noise).noisy;
  const auto objective = [noise](double smoothing_time) {
    return SmoothingObjective{.penalty = GetParam(), .lambda = lambda_of(smoothing_time, GetParam(), noise, 0.01)};
  };
  for (const double smoothing_time : {0.05, 0.2, 1.0}) {  // 5, 20 and 100 intervals
    const auto near = fit_smoothing(problem_of(data, noise), objective(smoothing_time / 1.3));
    const auto alone = fit_smoothing(problem_of(data, noise), objective(smoothing_time));
    const auto led = fit_smoothing(problem_of(data, noise), objective(smoothing_time), {}, &near.nodes);
    EXPECT_NEAR(led.cost, alone.cost, 1e-9 * alone.cost) << smoothing_time;
    EXPECT_LT(led.iterations, 20) << smoothing_time;
  }
}

INSTANTIATE_TEST_SUITE_P(Smoothing, EveryPenalty, testing::Values(Penalty::acceleration, Penalty::jerk));

template <int P>
void expect_jacobian_of_element() {
  using Element = SmoothingElement<P>;
  Dice dice(3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Eigen::Quaterniond from = exp<double>(dice.vector()), to = from * exp<double>(dice.vector());
    typename Element::Rates start, end;
    for (Eigen::Index k = 0; k < start.size(); k += 3) {
      start.template segment<3>(k) = 2.0 * dice.vector();
      end.template segment<3>(k) = 2.0 * dice.vector();
    }
    const double h = 0.7;
    const auto at = [&](const Eigen::Matrix<double, 2 * Element::unknowns, 1>& x) {
      constexpr int m = Element::unknowns;
      const Eigen::Quaterniond p = from * exp<double>(Eigen::Vector3d(x.template head<3>())),
                               q = to * exp<double>(Eigen::Vector3d(x.template segment<3>(m)));
      return Element::residual(shortest_increment(p, q), start + x.template segment<m - 3>(3),
                               end + x.template tail<m - 3>(), h);
    };
    const auto exact = Element::linearised(shortest_increment(from, to), start, end, h);
    Eigen::Matrix<double, 2 * Element::unknowns, 1> x = Eigen::Matrix<double, 2 * Element::unknowns, 1>::Zero();
    EXPECT_LT(relative_error(exact.residual, at(x)), 1e-12);
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      constexpr double step = 1e-3;
      x.setZero();
      const auto difference = [&](double d) {
        x[k] = d;
        const typename Element::Residual forward = at(x);
        x[k] = -d;
        return typename Element::Residual(forward - at(x));
      };
      const typename Element::Residual slope = (8.0 * difference(step) - difference(2.0 * step)) / (12.0 * step);
      EXPECT_LT(relative_error(typename Element::Residual(exact.jacobian.col(k)), slope), 1e-9) << k;
    }
  }
}

TEST(SmoothingElement, JacobianIsThatOfTheResidual) {
  expect_jacobian_of_element<2>();
  expect_jacobian_of_element<3>();
}

TEST(SmoothingLoss, WeightsAreTheSlopesOfValuesWithoutAJump) {
  constexpr double threshold = 2.5, bound = threshold * threshold, step = 1e-5;
  for (const Loss loss : {Loss::squares, Loss::huber, Loss::cauchy, Loss::tukey}) {
    SCOPED_TRACE(static_cast<int>(loss));
    for (const double s : {0.1, 1.0, 0.99 * bound, 1.01 * bound, 4.0 * bound}) {
      const double slope =
          (loss_at(loss, s + step, threshold).value - loss_at(loss, s - step, threshold).value) / (2.0 * step);
      EXPECT_NEAR(loss_at(loss, s, threshold).weight, slope, 1e-8) << s;
    }
    const LossValue within = loss_at(loss, bound * (1.0 - 1e-12), threshold),
                    beyond = loss_at(loss, bound * (1.0 + 1e-12), threshold);
    EXPECT_NEAR(within.value, beyond.value, 1e-10);
    EXPECT_NEAR(within.weight, beyond.weight, 1e-10);
  }
  EXPECT_EQ(loss_at(Loss::huber, 16.0, 2.0).value, 12.0);  // 2 c √s - c²
  EXPECT_EQ(loss_at(Loss::tukey, 100.0, 3.0).value, 3.0);  // c²/3
  EXPECT_EQ(loss_at(Loss::tukey, 100.0, 3.0).weight, 0.0);
  EXPECT_NEAR(loss_at(Loss::cauchy, 4.0, 2.0).value, 4.0 * std::log(2.0), 1e-14);
}

TEST(SmoothingTrace, IsThatOfTheSplineFilter) {
  // Far from the ends the kernel of a cubic smoothing spline has the height 1/(2√2 τ) (Silverman 1984).
  std::vector<double> times, weights(4000, 1.0);
  for (int i = 0; i < 4000; ++i) times.push_back(i);
  const double trace =
      hat_trace(times, weights, Penalty::acceleration, lambda_of(10.0, Penalty::acceleration, 1.0, 1.0));
  EXPECT_NEAR(trace / 4000.0, 1.0 / (20.0 * std::sqrt(2.0)), 0.001);
}

TEST(Smooth, ComesNearTheTruthWithoutBeingToldAnything) {
  const auto recording = recorded(1500, degree);
  const auto smoothing = smooth(Keyframes::make(recording.noisy).value()).value();
  EXPECT_EQ(smoothing.criterion, SmoothingCriterion::gcv);
  EXPECT_NEAR(smoothing.noise / degree, 1.0, 0.05);
  EXPECT_NEAR(smoothing.local_noise / degree, 1.0, 0.08);
  EXPECT_TRUE(smoothing.rejected.empty());
  const double found = rms(smoothing, recording.clean);
  EXPECT_LT(found, 0.45 * degree);
  for (const double factor : {0.5, 2.0}) {  // the choice is near the best one
    const SmoothOptions other{.smoothing_time = factor * smoothing.smoothing_time};
    EXPECT_GT(rms(smooth(Keyframes::make(recording.noisy).value(), other).value(), recording.clean), 0.95 * found);
  }
}

TEST(Smooth, FindsEveryOutlierAndNoOther) {
  auto recording = recorded(1500, degree);
  std::vector<std::size_t> faults;
  for (std::size_t i = 20; i < 1500; i += 73) {
    faults.push_back(i);
    recording.noisy.orientations[i] = recording.noisy.orientations[i] * exp<double>(Eigen::Vector3d(0.0, 0.35, 0.0));
  }
  const auto smoothing = smooth(Keyframes::make(recording.noisy).value()).value();
  EXPECT_EQ(smoothing.rejected, faults);
  const auto trusting = smooth(Keyframes::make(recording.noisy).value(), {.outliers = Outliers::none}).value();
  EXPECT_LT(rms(smoothing, recording.clean), 0.7 * rms(trusting, recording.clean));
}

TEST(Smooth, StretchesDoNotKnowEachOther) {
  const auto recording = recorded(300, degree);
  KeyframeData cut = recording.noisy, first = recording.noisy;
  for (std::size_t i = 150; i < 300; ++i) cut.times[i] += 5.0;
  cut.times[299] += 5.0;  // stands alone
  first.times.resize(150);
  first.orientations.resize(150);
  const SmoothOptions options{.smoothing_time = 0.05, .outliers = Outliers::none, .gap = 1.0};
  const auto whole = smooth(Keyframes::make(cut).value(), options).value();
  const auto part = smooth(Keyframes::make(first).value(), options).value();
  ASSERT_EQ(whole.stretches.size(), 2u);
  EXPECT_EQ(whole.stretches[1].first, 150u);
  EXPECT_EQ(whole.stretches[1].count, 149u);
  EXPECT_EQ(whole.left_out, std::vector<std::size_t>{299});
  ASSERT_EQ(whole.nodes.orientations.size(), 299u);
  for (std::size_t i = 0; i < 150; ++i)
    EXPECT_LT(angular_distance(whole.nodes.orientations[i], part.nodes.orientations[i]), 1e-8);
}

TEST(Smooth, GyroBringsTheMotionNearerAndItsBiasIsFound) {
  auto recording = recorded(1000, degree);
  const auto plain = smooth(Keyframes::make(recording.noisy).value()).value();
  const Eigen::Vector3d bias(0.02, -0.01, 0.03);
  Dice dice(11);
  for (const double t : recording.clean.times) {
    const Eigen::Quaterniond second = exp<double>(Eigen::Vector3d(std::sin(3.0 * t), 0.0, 0.0));
    const Eigen::Vector3d rate = to_body<double>(second, Eigen::Vector3d(0.0, 0.0, 2.0 * std::cos(2.0 * t))) +
                                 Eigen::Vector3d(3.0 * std::cos(3.0 * t), 0.0, 0.0);
    recording.noisy.angular_velocities.push_back(rate + bias + 0.01 * normal_vector(dice));
  }
  const auto fused = smooth(Keyframes::make(recording.noisy).value(), {.gyro = true}).value();
  EXPECT_EQ(fused.criterion, SmoothingCriterion::reml);
  EXPECT_NEAR(*fused.gyro_noise, 0.01, 0.001);
  EXPECT_LT((fused.nodes.gyro_correction + bias).norm(), 0.003);
  EXPECT_LT(rms(fused, recording.clean), 0.6 * rms(plain, recording.clean));
}

void expect_refusal(const KeyframeData& data, const SmoothOptions& options, ErrorCode code, const char* message) {
  const auto refused = smooth(Keyframes::make(data).value(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code);
  EXPECT_EQ(refused.error().message, message);
}

TEST(Smooth, SaysWhatItCannotDo) {
  const auto data = recorded(100, degree).noisy;
  const KeyframeData two{.times = {0.0, 1.0}, .orientations = {2, Eigen::Quaterniond::Identity()}};
  expect_refusal(two, {}, ErrorCode::bad_data, "found 2 samples, wanted at least 3 to smooth");
  expect_refusal(data, {.noise = 0.0}, ErrorCode::bad_argument, "noise: found 0, wanted radians greater than 0");
  expect_refusal(data, {.noise = 0.1, .smoothing_time = 1.0}, ErrorCode::bad_argument,
                 "found a noise and a smoothing time, wanted one of them: each determines how smooth");
  expect_refusal(data, {.gap = 0.01}, ErrorCode::bad_argument,
                 "gap: found 0.01 s, wanted more than the median interval of 0.01 s");
  expect_refusal(data, {.gyro = true}, ErrorCode::bad_data, "found no angular velocities, wanted those of the gyro");
  KeyframeData wild = data;
  Dice dice(5);
  for (Eigen::Quaterniond& q : wild.orientations) q = exp<double>(Eigen::Vector3d(3.0 * dice.vector()));
  const auto refused = smooth(Keyframes::make(wild).value());
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().message.starts_with("no smooth motion is near to the samples"))
      << refused.error().message;
}

}  // namespace
}  // namespace orispline::optimise
