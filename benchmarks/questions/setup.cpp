// SPDX-License-Identifier: Apache-2.0
// What does a curve cost before its first sample?
#include <benchmark/benchmark.h>

#include <memory>
#include <orispline/batch/compiled_curve.hpp>
#include <questions/questions.hpp>
#include <workload/keys.hpp>

namespace orispline::bench {
namespace {

/// Work that makes something, which is destroyed outside the measurement.
template <class Make>
void measure_making(const std::string& name, const Sizes& sizes, Make make) {
  benchmark::RegisterBenchmark(("setup/" + name + "/" + std::to_string(sizes.setup_keys)).c_str(),
                               [make, keys = sizes.setup_keys](benchmark::State& state) {
                                 for ([[maybe_unused]] auto _ : state) {
                                   auto made = std::make_optional(make());
                                   benchmark::DoNotOptimize(&*made);
                                   state.PauseTiming();
                                   made.reset();
                                   state.ResumeTiming();
                                 }
                                 state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(keys));
                               })
      ->Repetitions(sizes.setup_repetitions);
}

}  // namespace

void ask_setup(const Sizes& sizes) {
  const auto track = std::make_shared<const Track>(random_track(sizes.setup_keys, 42));
  const Keyframes keys = keys_of(*track);
  KeyframeData data;
  data.times.assign(keys.times().begin(), keys.times().end());
  data.orientations.assign(keys.orientations().begin(), keys.orientations().end());
  const AnyCurve curve = value_or_give_up(make_curve("timed-c2", keys));
  measure_making("keyframes", sizes, [data] { return value_or_give_up(Keyframes::make(data)); });
  for (const char* method : {"timed-c2", "quintic", "auto", "auto5"})
    measure_making(method, sizes, [keys, method] { return value_or_give_up(make_curve(method, keys)); });
  measure_making("compile", sizes, [curve] { return CompiledCurve<double>(curve); });
}

}  // namespace orispline::bench
