// SPDX-License-Identifier: Apache-2.0
#include <fuzz/optimise_claims.hpp>
#include <fuzz/outcome_claims.hpp>
#include <fuzz/segment_scale.hpp>
#include <orispline/jobs/smooth.hpp>
#include <support/specimens.hpp>

namespace orispline::fuzz {

namespace {

SmoothOptions fuzzed_smoothing(TaskInput& input) {
  SmoothOptions options;
  Flags flags(input.options);
  options.penalty = flags.next() ? Penalty::jerk : Penalty::acceleration;
  options.loss = std::array{Loss::robust, Loss::l2, Loss::huber, Loss::tukey}[flags.next(4)];
  const unsigned stated = flags.next(4);
  const double size = std::pow(10.0, static_cast<double>(input.options.below(9)) - 6.0);
  if (stated == 1) options.noise = std::min(size, 0.5);
  if (stated == 2) options.smoothing_time = size;
  Flags more(input.more);
  options.adapt = !more.next();
  options.sigma = more.next();
  options.gyro = more.next();
  const double other = std::pow(10.0, static_cast<double>(input.more.below(9)) - 6.0);
  if (more.next()) options.gap = other;
  if (more.next() && options.gyro) options.gyro_noise = other;
  if (more.next()) options.position_noise = other;
  return options;
}

void claim_finite(const Smoothing& smoothing, const SmoothOptions& options) {
  const Keyframes& keys = smoothing.track.keys;
  for (const Eigen::Quaterniond& q : keys.orientations()) claim(q.coeffs().allFinite(), "an orientation is not finite");
  for (const auto& rates : {keys.angular_velocities(), keys.angular_accelerations(), keys.positions()})
    for (const Eigen::Vector3d& rate : rates) claim(rate.allFinite(), "a rate or a position is not finite");
  for (const double number : {smoothing.smoothing_time, smoothing.lambda, smoothing.noise, smoothing.local_noise})
    claim(std::isfinite(number), "a result is {}", number);
  for (const double time : smoothing.smoothing_times)
    claim(std::isfinite(time) && time > 0.0, "a smoothing time is {}", time);
  claim(smoothing.smoothing_times.empty() || smoothing.smoothing_times.size() == keys.size(),
        "{} smoothing times of {} keys", smoothing.smoothing_times.size(), keys.size());
  claim(smoothing.sigmas.has_value() == options.sigma, "standard deviations: {}", smoothing.sigmas.has_value());
  if (!smoothing.sigmas) return;
  for (const auto* list : {&smoothing.sigmas->orientations, &smoothing.sigmas->angular_velocities})
    for (const Eigen::Vector3d& sigma : *list)
      claim(sigma.allFinite() && (sigma.array() >= 0.0).all(), "a standard deviation is {}", sigma.norm());
}

}  // namespace

void try_smooth(TaskInput& input) {
  const SmoothOptions options = fuzzed_smoothing(input);
  const Situation situation([&] {
    return fmt::format("smooth: penalty {}, loss {}, noise {}, smoothing time {}, adapt {}, sigma {}, gyro {}, gap {}",
                       static_cast<int>(options.penalty.value_or(Penalty::acceleration)),
                       static_cast<int>(options.loss), options.noise.value_or(0.0),
                       options.smoothing_time.value_or(0.0), options.adapt, options.sigma, options.gyro,
                       options.gap.value_or(0.0));
  });
  const Stopwatch stopwatch;
  const auto outcome = jobs::smooth({.recording = input.recording, .options = options});
  if (!outcome) return claim_plain(outcome.error());
  claim_told(*outcome);
  const Smoothing& smoothing = outcome->smoothing;
  claim_finite(smoothing, options);
  const AnyCurve curve = curve_of(smoothing.method, smoothing.track.keys);
  for (const double t : testing_support::sample_times(curve.knots().times()))
    claim(is_finite(curve.motion(t)), "the motion at t = {} is not finite", t);
}

}  // namespace orispline::fuzz
