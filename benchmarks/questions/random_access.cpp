// SPDX-License-Identifier: Apache-2.0
// What does one sample at any time cost, search included?
#include <benchmark/benchmark.h>

#include <memory>
#include <peers/peers.hpp>
#include <questions/questions.hpp>
#include <workload/buffer.hpp>
#include <workload/keys.hpp>
#include <workload/verify.hpp>

namespace orispline::bench {

namespace {

struct Scene {
  Track track;
  Definition definition;
  CompiledCurve<double> compiled;
  std::vector<double> times;
  Buffer<double> out;

  Scene(Track keys, std::size_t samples)
      : track(std::move(keys)),
        definition(track),
        compiled(curve_through(track)),
        times(random_times(track, samples, 3)),
        out(4 * samples) {}
};

/// The time of each evaluation waits for the one before: how long one takes, not how many go on side by side.
void one_after_the_other(const Scene& scene) {
  double nothing = 0.0;
  for (const double t : scene.times) nothing = 1e-300 * scene.compiled(t + nothing).w();
  benchmark::DoNotOptimize(nothing);
}

}  // namespace

void ask_random_access(const Sizes& sizes, Errors& errors) {
  const auto scene = std::make_shared<Scene>(random_track(sizes.keys, 42), sizes.random_accesses);
  const auto enter = [&](const std::string& name, double limit, auto run) {
    run();
    const double error = largest_error<double>(scene->out.all(), Layout::interleaved, [&](std::size_t k) {
      return scene->definition.quintic(scene->times[k]);
    });
    measure(name, scene->times.size(), run);
    return accept(name, error, limit);
  };
  errors.add_double(enter("random/ours", 1.2 * our_limit, [scene] {
    for (std::size_t k = 0; k < scene->times.size(); ++k)
      Eigen::Vector4d::Map(&scene->out.all()[4 * k]) = scene->compiled(scene->times[k]).coeffs();
  }));
  errors.add_double(enter("random/ours sample_at", 1.2 * our_limit, [scene] {
    check(sample_at<double>(scene->compiled, scene->times, {.orientations = scene->out.all()}));
  }));
  for (const Peer<double>& peer : peers_of(scene->track))
    if (peer.shape == Shape::quintic)
      enter("random/" + peer.name, peer_limit,
            [scene, sample = peer.sample] { sample(scene->times, scene->out.all()); });
  measure("random/ours, one after the other", scene->times.size(), [scene] { one_after_the_other(*scene); });
}

}  // namespace orispline::bench
