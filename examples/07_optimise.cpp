// SPDX-License-Identifier: Apache-2.0
// From a noisy recording to a motion within limits: smooth, reduce, tune, retime. The parts are those of
// docs/optimise.md.

#include <cmath>
#include <cstdio>

#include <orispline/orispline.hpp>
#include <orispline/reduce.hpp>
#include <orispline/retime.hpp>
#include <orispline/smooth.hpp>
#include <orispline/tune.hpp>

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

/// Six seconds at 50 Hz, with about half a degree of noise.
orispline::Expected<orispline::Keyframes> recorded() {
  orispline::KeyframeData data;
  for (int i = 0; i <= 300; ++i) {
    const double t = 0.02 * i;
    const Eigen::Vector3d noise(std::sin(997.0 * t * t), std::sin(877.0 * t * t), std::sin(761.0 * t * t));
    const auto truth = orispline::exp(Eigen::Vector3d(std::sin(t), 0.3 * t, std::cos(0.7 * t)));
    data.times.push_back(t);
    data.orientations.push_back(truth * orispline::exp(Eigen::Vector3d(0.7 * degree * noise)));
  }
  return orispline::Keyframes::make(data);
}

orispline::Expected<orispline::Track> smoothed(const orispline::Track& recording) {
  const auto smoothing = orispline::smooth(recording, {.penalty = orispline::Penalty::jerk});
  if (!smoothing) return tl::unexpected(smoothing.error());
  std::printf("smooth: noise of %.1f degrees per axis\n", smoothing->noise / degree);
  return smoothing->track;
}

orispline::Expected<orispline::Track> reduced(const orispline::Track& recording) {
  const auto reduction = orispline::reduce(recording, "timed-c2", {.tolerance = {.angle = 0.5 * degree}});
  if (!reduction) return tl::unexpected(reduction.error());
  std::printf("reduce: %zu of %zu keys, %s\n", reduction->track.keys.size(), recording.keys.size(),
              reduction->deviation.angle <= 0.5 * degree ? "within half a degree" : "too far");
  return reduction->track;
}

orispline::Expected<orispline::Track> tuned(const orispline::Track& keys) {
  const auto tuning = orispline::tune(keys, "timed-c2", {.objective = orispline::Objective::acceleration});
  if (!tuning) return tl::unexpected(tuning.error());
  const bool lower = tuning->energy_after < tuning->energy_before;
  std::printf("tune: %zu tensions per key, %s energy\n", tuning->parameters.size(), lower ? "less" : "the same");
  return tuning->track;
}

orispline::Expected<orispline::AnyCurve> retimed(const orispline::Track& keys) {
  const orispline::MotionLimits limits{.rate = 20.0 * degree, .acceleration = 40.0 * degree};
  const auto retiming = orispline::retime(keys, "timed-c2", {.limits = limits});
  if (!retiming) return tl::unexpected(retiming.error());
  std::printf("retime: slowed by %.1f\n", retiming->time_scale);
  return orispline::make_curve(retiming->method, retiming->track.keys);
}

}  // namespace

int main() {
  const auto keys = recorded().and_then(smoothed).and_then(reduced).and_then(tuned);
  if (!keys || !retimed(*keys)) return 1;
  const auto refused = orispline::retime(*keys, "slerp", {.limits = {.acceleration = 1.0}});
  std::printf("%s\n", orispline::describe(refused.error()).c_str());
}
