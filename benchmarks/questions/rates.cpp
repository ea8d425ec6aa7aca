// SPDX-License-Identifier: Apache-2.0
// What does a sample cost with its angular velocity and acceleration?
#include <benchmark/benchmark.h>

#include <memory>
#include <questions/questions.hpp>
#include <questions/truth.hpp>
#include <workload/buffer.hpp>
#include <workload/keys.hpp>

namespace orispline::bench {

namespace {

struct Scene {
  Track track;
  Definition definition;
  AnyCurve curve;
  EvenTimes t;
  std::vector<double> times;
  Buffer<double> orientations, velocities, accelerations;

  Scene(Track keys, std::size_t samples)
      : track(std::move(keys)),
        definition(track),
        curve(curve_through(track)),
        t(even_times(track, samples)),
        times(t.all()),
        orientations(4 * samples),
        velocities(3 * samples),
        accelerations(3 * samples) {}

  /// The largest error of an orientation; ends the program when one of the rates is off.
  double verify(const std::string& name, Shape shape, double limit) {
    const ShapeTruth truth(shape, track, definition);
    const double error = largest_error<double>(orientations.all(), Layout::interleaved,
                                               [&](std::size_t k) { return truth.orientation(t[k]); });
    double of_rates = 0.0;
    for (std::size_t k = 0; k < t.count; k += stride(t.count) * 17) {
      const Eigen::Map<const Eigen::Vector3d> omega(&velocities.all()[3 * k]), alpha(&accelerations.all()[3 * k]);
      const double off = std::max((omega - truth.angular_velocity(t[k]).cast<double>()).norm(),
                                  (alpha - truth.angular_acceleration(t[k]).cast<double>()).norm());
      if (!(off <= of_rates)) of_rates = off;
    }
    accept(name + " (ω, α)", of_rates, rates_limit);
    return accept(name, error, limit);
  }
};

}  // namespace

void ask_rates(const Sizes& sizes, Errors& errors) {
  const std::size_t samples = std::min<std::size_t>(sizes.samples.back(), 1'000'000);
  const auto scene = std::make_shared<Scene>(random_track(sizes.keys, 42), samples);
  const auto enter = [&](const std::string& name, Shape shape, double limit, auto run) {
    run();
    measure(name, samples, run);
    return scene->verify(name, shape, limit);
  };
  errors.add_double(enter("rates/ours", Shape::quintic, 1.2 * our_limit, [scene] {
    check(sample_uniform<double>(scene->curve, scene->t.t0, scene->t.dt,
                                 {.orientations = scene->orientations.all(),
                                  .angular_velocities = scene->velocities.all(),
                                  .angular_accelerations = scene->accelerations.all()}));
  }));
  for (const RatesPeer& peer : rates_peers_of(scene->track))
    enter("rates/" + peer.name, peer.shape, peer_limit, [scene, sample = peer.sample] {
      sample(scene->times, scene->orientations.all(), scene->velocities.all(), scene->accelerations.all());
    });
}

void ask_auto(const Sizes& sizes) {
  const std::size_t samples = std::min<std::size_t>(sizes.samples.back(), 1'000'000);
  const Track track = random_track(sizes.keys, 42);
  const AnyCurve curve = curve_through(track, "auto");
  const EvenTimes t = even_times(track, samples);
  const auto out = std::make_shared<Buffer<double>>(4 * samples);
  const auto run = [curve, t, out] { check(sample_uniform<double>(curve, t.t0, t.dt, {.orientations = out->all()})); };
  run();
  const double error =
      largest_error<double>(out->all(), Layout::interleaved, [&](std::size_t k) { return curve(t[k]).cast<Real>(); });
  accept("auto/ours, against the scalar evaluator", error, 4.0 * our_limit);
  measure("auto/ours", samples, run);
}

}  // namespace orispline::bench
