// SPDX-License-Identifier: Apache-2.0
// What does a sample of one curve cost? Ours in all its forms, and the peers, on the same keys at the same times.
#include <benchmark/benchmark.h>

#include <memory>
#include <questions/questions.hpp>
#include <questions/truth.hpp>
#include <workload/buffer.hpp>
#include <workload/keys.hpp>

namespace orispline::bench {

namespace {

/// What all contenders share: the keys, the curve and room for the samples.
struct Scene {
  Track track;
  Definition definition;
  AnyCurve curve;
  CompiledCurve<double> compiled;
  Buffer<double> out;
  Buffer<float> float_out;

  explicit Scene(const Sizes& sizes)
      : track(random_track(sizes.keys, 42)),
        definition(track),
        curve(curve_through(track)),
        compiled(curve),
        out(4 * sizes.samples.back()),
        float_out(4 * sizes.samples.back()) {}

  template <class T>
  [[nodiscard]] std::span<T> room(std::size_t samples) {
    if constexpr (std::is_same_v<T, double>) return out.first(4 * samples);
    else return float_out.first(4 * samples);
  }
  [[nodiscard]] Truth truth(Shape shape, const EvenTimes& times) const {
    return [truth = ShapeTruth(shape, track, definition), times](std::size_t k) { return truth.orientation(times[k]); };
  }
};

template <class T>
constexpr const char* name_of_number = std::is_same_v<T, double> ? "double" : "float";

template <class T>
std::string name_of(const std::string& contender, std::size_t samples) {
  return "one_curve/" + contender + "/" + name_of_number<T> + "/" + std::to_string(samples);
}

/// Ours: verified on the first call, then timed.
template <class T, class Work>
void enter_ours(const std::shared_ptr<Scene>& scene, const std::string& contender, const EvenTimes& times,
                Layout layout, Errors& errors, Work sample_into) {
  const std::string name = name_of<T>(contender, times.count);
  const auto run = [scene, layout, sample_into, count = times.count] {
    const std::span<T> out = scene->room<T>(count);
    check(sample_into(Samples<T>{.orientations = out, .layout = layout}));
    benchmark::DoNotOptimize(out.data());
  };
  std::ranges::fill(scene->room<T>(times.count), T(7));
  run();
  const double error = largest_error<T>(scene->room<T>(times.count), layout, scene->truth(Shape::quintic, times));
  if constexpr (std::is_same_v<T, double>) errors.add_double(accept(name, error, our_limit * 1.2));
  else errors.add_float(accept(name, error, our_float_limit));
  measure(name, times.count, run);
}

template <class T>
void enter_our_forms(const std::shared_ptr<Scene>& scene, const EvenTimes& t, Errors& errors) {
  const auto uniform = [scene, t](const Samples<T>& out) { return sample_uniform(scene->curve, t.t0, t.dt, out); };
  enter_ours<T>(scene, "ours", t, Layout::interleaved, errors, uniform);
  enter_ours<T>(scene, "ours planar", t, Layout::planar, errors, uniform);
  enter_ours<T>(scene, "ours at given times", t, Layout::interleaved, errors,
                [scene, times = std::make_shared<std::vector<double>>(t.all())](const Samples<T>& out) {
                  return sample(scene->curve, std::span<const double>(*times), out);
                });
}

template <class T>
void enter_peer(const std::shared_ptr<Scene>& scene, Peer<T> peer, const EvenTimes& t) {
  const std::string name = name_of<T>(peer.name, t.count);
  if constexpr (std::is_same_v<T, double>)
    if (peer.shape == Shape::through_keys) accept_at_keys(peer, scene->track);
  const Shape shape = peer.shape;
  const auto run = [scene, sample = std::move(peer.sample), times = std::make_shared<std::vector<double>>(t.all())] {
    const std::span<T> out = scene->room<T>(times->size());
    sample(*times, out);
    benchmark::DoNotOptimize(out.data());
  };
  std::ranges::fill(scene->room<T>(t.count), T(7));
  run();
  if (shape != Shape::through_keys)
    accept(name, largest_error<T>(scene->room<T>(t.count), Layout::interleaved, scene->truth(shape, t)),
           std::is_same_v<T, double> ? peer_limit : peer_float_limit);
  measure(name, t.count, run);
}

void enter_two_threads(const std::shared_ptr<Scene>& scene, const EvenTimes& t) {
  benchmark::RegisterBenchmark((name_of<double>("ours on two threads", t.count)).c_str(), [scene,
                                                                                           t](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      check(sample_uniform<double>(scene->curve, t.t0, t.dt, {.orientations = scene->room<double>(t.count)},
                                   {.threads = 2}));
      benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(t.count));
  })->UseRealTime();
}

void enter_fresh_pages(const std::shared_ptr<Scene>& scene, const EvenTimes& t) {
  measure("fresh_pages/ours/double/" + std::to_string(t.count), t.count, [scene, t] {
    const std::unique_ptr<double[]> fresh(new double[4 * t.count]);
    check(sample_uniform<double>(scene->curve, t.t0, t.dt, {.orientations = {fresh.get(), 4 * t.count}}));
    benchmark::DoNotOptimize(fresh.get());
  });
}

}  // namespace

void ask_one_curve(const Sizes& sizes, Errors& errors) {
  const auto scene = std::make_shared<Scene>(sizes);
  for (const std::size_t samples : sizes.samples) {
    const EvenTimes times = even_times(scene->track, samples);
    enter_our_forms<double>(scene, times, errors);
    enter_our_forms<float>(scene, times, errors);
    for (Peer<double>& peer : peers_of(scene->track)) enter_peer(scene, std::move(peer), times);
    for (Peer<float>& peer : float_peers_of(scene->track)) enter_peer(scene, std::move(peer), times);
  }
  const EvenTimes most = even_times(scene->track, sizes.samples.back());
  enter_two_threads(scene, most);
  enter_fresh_pages(scene, most);
}

void ask_samples_per_segment(const Sizes& sizes, Errors& errors) {
  Sizes room = sizes;
  room.samples = {sizes.keys * *std::ranges::max_element(sizes.per_segment)};
  const auto scene = std::make_shared<Scene>(room);
  for (const std::size_t n : sizes.per_segment) {
    const EvenTimes t = even_times(scene->track, n * sizes.keys);
    const std::string at = "/" + std::to_string(n);
    enter_ours<double>(
        scene, "ours, samples per segment" + at, t, Layout::interleaved, errors,
        [scene, t](const Samples<double>& out) { return sample_uniform(scene->curve, t.t0, t.dt, out); });
    enter_ours<double>(
        scene, "ours compiled, samples per segment" + at, t, Layout::interleaved, errors,
        [scene, t](const Samples<double>& out) { return sample_uniform(scene->compiled, t.t0, t.dt, out); });
  }
}

}  // namespace orispline::bench
