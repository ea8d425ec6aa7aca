// SPDX-License-Identifier: Apache-2.0
// What a gyro may do without harm: its clock, its faults, its gaps. ORISPLINE_SWEEP=all in the environment takes every
// fault and seed.
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include <orispline/math/median.hpp>

#include "smooth/gyro_motion.hpp"
#include "smooth/safety_net.hpp"

namespace orispline::gyro_motion { namespace {

using Rates = std::vector<Eigen::Vector3d>;

Smoothing with_gyro(const KeyframeData& data, SmoothOptions options = {}) {
  options.gyro = true;
  return smoothed(data, options);
}

bool has(const Smoothing& smoothing, std::string_view code) {
  return std::ranges::any_of(smoothing.warnings, [&](const Warning& warning) { return warning.code == code; });
}

TEST(GyroClock, IsFoundToATenthOfASampleInterval) {
  std::vector<double> errors, in_sigmas;
  const std::uint64_t seeds = known_truth::sweeps() ? 20 : 4;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const double late = 0.3 * static_cast<double>(seed) / static_cast<double>(seeds - 1);
    const Smoothing smoothing = with_gyro(recorded(seed, late).noisy);
    errors.push_back(std::abs(smoothing.gyro->offset - late));
    ASSERT_TRUE(smoothing.gyro->offset_sigma);
    in_sigmas.push_back(errors.back() / *smoothing.gyro->offset_sigma);
  }
  EXPECT_LE(median(errors), 0.3e-3);
  EXPECT_LE(median(in_sigmas), 1.2);
  EXPECT_LE(std::ranges::max(in_sigmas), 4.0);
}

struct Fault {
  std::string name;
  std::function<Recorded(std::uint64_t seed)> made;
};

Fault disturbed(std::string name, std::function<void(Rates&, Dice&)> disturb) {
  return {std::move(name), [disturb = std::move(disturb)](std::uint64_t seed) {
            Recorded made = recorded(seed);
            Dice dice(300 + seed);
            disturb(made.noisy.angular_velocities, dice);
            return made;
          }};
}

/// Runs of `length` rates, `count` of them, each set by `set`.
Fault runs(const std::string& name, std::size_t length, std::size_t count,
           const std::function<Eigen::Vector3d(const Eigen::Vector3d&, Dice&)>& set) {
  return disturbed(name + " in runs of " + std::to_string(length), [=](Rates& rates, Dice& dice) {
    for (std::size_t run = 0; run < count; ++run) {
      const auto first = static_cast<std::size_t>(dice.between(0.02, 0.95) * static_cast<double>(rates.size()));
      for (std::size_t k = first; k < std::min(first + length, rates.size()); ++k) rates[k] = set(rates[k], dice);
    }
  });
}

std::vector<Fault> faults() {
  std::vector<Fault> all;
  for (const std::size_t length : {1u, 2u, 3u, 5u, 10u, 20u, 50u}) {
    if (!known_truth::sweeps() && length != 3 && length != 50) continue;
    const std::size_t count = std::max<std::size_t>(1, 100 / length);
    all.push_back(runs("spikes", length, count, [](const Eigen::Vector3d& rate, Dice& dice) {
      return Eigen::Vector3d(rate + Eigen::Vector3d::Unit(static_cast<Eigen::Index>(dice.between(0.0, 2.999))) * 35.0);
    }));
    all.push_back(runs("zeros", length, count,
                       [](const Eigen::Vector3d&, Dice&) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }));
    all.push_back(runs("small spikes", length, count, [](const Eigen::Vector3d& rate, Dice& dice) {
      return Eigen::Vector3d(rate + 0.5 * dice.vector());
    }));
  }
  for (const double share : {0.9, 0.7, 0.5, 0.3})
    all.push_back(disturbed("clipped at " + std::to_string(share), [share](Rates& rates, Dice&) {
      double largest = 0.0;
      for (const Eigen::Vector3d& rate : rates) largest = std::max(largest, rate.lpNorm<Eigen::Infinity>());
      for (Eigen::Vector3d& rate : rates) rate = rate.cwiseMax(-share * largest).cwiseMin(share * largest);
    }));
  for (const double step : {0.2, 1.0, 5.0, 20.0})
    all.push_back(disturbed("bias that steps by " + std::to_string(step), [step](Rates& rates, Dice& dice) {
      const Eigen::Vector3d change = step * degree * dice.vector();
      for (std::size_t k = rates.size() / 2; k < rates.size(); ++k) rates[k] += change;
    }));
  for (const double late : {0.005, 0.02, 0.1, 0.2, 0.3})
    all.push_back(
        {"stamps late by " + std::to_string(late), [late](std::uint64_t seed) { return recorded(seed, late); }});
  return all;
}

TEST(Gyro, NeverMakesTheMotionWorse) {
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < (known_truth::sweeps() ? 5 : 1); ++seed) {
    Recorded alone = recorded(seed);
    alone.noisy.angular_velocities.clear();
    const double without = rms(smoothed(alone.noisy), alone.clean);  // faults of rates do not change it
    for (const Fault& fault : faults()) {
      const Recorded made = fault.made(seed);
      const double found = rms(with_gyro(made.noisy), made.clean);
      EXPECT_LE(found, 1.05 * without) << fault.name << ", seed " << seed;
      worst = std::max(worst, found / without);
    }
  }
  std::printf("worst ratio %.3f\n", worst);
}

/// A gyro whose bias walks by so much in a second [rad/s].
Recorded walking(std::uint64_t seed, double drift) {
  Recorded made = recorded(seed);
  Dice dice(400 + seed);
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  for (Eigen::Vector3d& rate : made.noisy.angular_velocities) {
    bias += 0.1 * drift * normal_vector(dice);
    rate += bias;
  }
  return made;
}

TEST(GyroBias, IsFollowedWhereItDrifts) {
  const double drift = 1.0 * degree;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const Recorded made = walking(seed, drift);
    const Smoothing constant = with_gyro(made.noisy, {.gyro_bias = GyroBias::constant}),
                    drifting = with_gyro(made.noisy, {.gyro_bias = GyroBias::drifting});
    EXPECT_TRUE(drifting.gyro->used);
    EXPECT_LT(rms(drifting, made.clean), 0.75 * rms(constant, made.clean));
    ASSERT_TRUE(drifting.gyro->drift);
    EXPECT_LT(*drifting.gyro->drift, 2.5 * drift);
    EXPECT_GT(*drifting.gyro->drift, 0.4 * drift);
    EXPECT_EQ(drifting.nodes.gyro_corrections.size(), drifting.nodes.orientations.size());
    EXPECT_FALSE(constant.gyro->drift);
  }
}

TEST(GyroBias, IsCorrectedWhereItHasATrend) {
  Recorded made = recorded(1);
  const Eigen::Vector3d trend = degree * Eigen::Vector3d(0.25, -0.15, 0.1);
  const double untroubled = rms(with_gyro(made.noisy), made.clean);
  for (std::size_t k = 0; k < made.noisy.times.size(); ++k)
    made.noisy.angular_velocities[k] += made.noisy.times[k] * trend;
  const Smoothing found = with_gyro(made.noisy), constant = with_gyro(made.noisy, {.gyro_bias = GyroBias::constant});
  ASSERT_TRUE(found.gyro->trend);
  EXPECT_LT((found.gyro->trend->value + trend).norm(), 4.0 * found.gyro->trend->sigma.norm());
  EXPECT_LT(rms(found, made.clean), 1.1 * untroubled);
  EXPECT_FALSE(constant.gyro->trend);
  EXPECT_GT(rms(constant, made.clean), 1.5 * untroubled);
}

TEST(GyroBias, CostsLittleToFollowWhereItIsConstant) {
  const Recorded made = recorded(3);
  EXPECT_LT(rms(with_gyro(made.noisy, {.gyro_bias = GyroBias::drifting}), made.clean),
            1.1 * rms(with_gyro(made.noisy), made.clean));
}

TEST(Gyro, CountsHoweverItIsMounted) {
  const Recorded aligned = recorded(5, 0.0, 600);
  const double error = rms(with_gyro(aligned.noisy), aligned.clean);
  for (const double angle : {6.0, 175.0}) {
    Recorded made = aligned;
    const Eigen::Vector3d axis(0.5, 0.3, -0.8), mount = angle * degree * axis.normalized();
    const Eigen::Quaterniond to_body = exp<double>(mount);
    for (Eigen::Vector3d& rate : made.noisy.angular_velocities) rate = to_body.conjugate() * rate;
    const Smoothing found = with_gyro(made.noisy);
    ASSERT_TRUE(found.gyro->used && found.gyro->mount) << angle;
    EXPECT_LT((found.gyro->mount->value - mount).norm(), 0.3 * degree) << angle;
    EXPECT_LT(rms(found, made.clean), 1.1 * error) << angle;
    EXPECT_EQ(has(found, "gyro_turned"), angle > 20.0) << angle;
  }
}

TEST(Gyro, IsLeftOutWhereItTellsNothingOfTheMotion) {
  const std::vector<std::pair<const char*, std::function<void(Rates&)>>> nothing{
      {"constant", [](Rates& rates) { std::ranges::fill(rates, Eigen::Vector3d(0.5, 0.5, 0.5)); }},
      {"zero", [](Rates& rates) { std::ranges::fill(rates, Eigen::Vector3d(0.0, 0.0, 0.0)); }},
      {"random",
       [](Rates& rates) { std::ranges::generate(rates, [dice = Dice(7)]() mutable { return dice.vector(); }); }},
      {"of another body", [](Rates& rates) { rates = recorded(9, 0.0, 600).noisy.angular_velocities; }},
  };
  for (const auto& [name, set] : nothing) {
    Recorded made = recorded(0, 0.0, 600);
    set(made.noisy.angular_velocities);
    const Smoothing found = with_gyro(made.noisy);
    EXPECT_FALSE(found.gyro->used) << name;
    EXPECT_TRUE(has(found, "gyro_left_out")) << name;
    made.noisy.angular_velocities.clear();
    EXPECT_EQ(rms(found, made.clean), rms(smoothed(made.noisy), made.clean)) << name;
  }
}

TEST(Gyro, OfABodyAtRestDoesNoHarm) {
  Recorded made = recorded(2, 0.0, 600);
  Dice dice(3);
  for (std::size_t i = 0; i < made.noisy.times.size(); ++i) {
    made.clean.orientations[i] = made.clean.orientations.front();
    made.noisy.orientations[i] =
        made.clean.orientations[i] * exp<double>(Eigen::Vector3d(0.5 * degree * normal_vector(dice)));
    made.noisy.angular_velocities[i] = 0.57 * degree * normal_vector(dice);
  }
  const double with = rms(with_gyro(made.noisy), made.clean);
  made.noisy.angular_velocities.clear();
  EXPECT_LE(with, 1.05 * rms(smoothed(made.noisy), made.clean));
}

TEST(Gyro, IsSaidToContradictAStatedNoise) {
  const Recorded made = recorded(4);
  EXPECT_FALSE(has(with_gyro(made.noisy, {.noise = 0.5 * degree}), "noise_contradicted"));
  EXPECT_TRUE(has(with_gyro(made.noisy, {.noise = 0.35 * degree}), "noise_contradicted"));
  EXPECT_TRUE(has(with_gyro(made.noisy, {.noise = 0.7 * degree}), "noise_contradicted"));
}

}}  // namespace orispline::gyro_motion
