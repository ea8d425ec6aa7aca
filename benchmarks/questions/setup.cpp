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
void measure_making(const std::string& name, std::size_t keys, int repetitions, Make make) {
  benchmark::RegisterBenchmark(("setup/" + name + "/" + std::to_string(keys)).c_str(), [make,
                                                                                        keys](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      auto made = std::make_optional(make());
      benchmark::DoNotOptimize(&*made);
      state.PauseTiming();
      made.reset();
      state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(keys));
  })->Repetitions(repetitions);
}

}  // namespace

void ask_setup(const Sizes& sizes) {
  const auto measure_these = [&](const std::string& name, auto make) {
    measure_making(name, sizes.setup_keys, sizes.setup_repetitions, make);
  };
  const auto track = std::make_shared<const Track>(random_track(sizes.setup_keys, 42));
  const Keyframes keys = keys_of(*track);
  KeyframeData data;
  data.times.assign(keys.times().begin(), keys.times().end());
  data.orientations.assign(keys.orientations().begin(), keys.orientations().end());
  const AnyCurve curve = value_or_give_up(make_curve("timed-c2", keys));
  measure_these("keyframes", [data] { return value_or_give_up(Keyframes::make(data)); });
  for (const char* method : {"timed-c2", "quintic", "auto", "auto5", "measured"})
    measure_these(method, [keys, method] { return value_or_give_up(make_curve(method, keys)); });
  measure_these("compile", [curve] { return CompiledCurve<double>(curve); });
  for (const std::size_t count : {10u, 1000u, 10000u})  // as SciPy's makes them
    measure_making("rotation-spline", count, sizes.setup_repetitions, [all = keys_of(random_track(count, 42))] {
      return value_or_give_up(make_curve("rotation-spline", all));
    });
}

}  // namespace orispline::bench
