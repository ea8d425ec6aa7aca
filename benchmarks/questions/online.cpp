// SPDX-License-Identifier: Apache-2.0
// What does a key cost in a stream, in the worst of many cases? Every append is timed by itself, the clock's own time
// (some 20 to 40 ns) included.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <orispline/batch/online_curve.hpp>
#include <questions/questions.hpp>
#include <workload/keys.hpp>

namespace orispline::bench {
namespace {

double nanoseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

double quantile(std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

void append_all(benchmark::State& state, const Keyframes& keys) {
  std::vector<double> taken(keys.size());
  for ([[maybe_unused]] auto _ : state) {
    OnlineCurve curve = value_or_give_up(OnlineCurve::make("timed-c2", 1000));
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const auto start = std::chrono::steady_clock::now();
      const Expected<void> appended = curve.append(keys.times()[k], keys.orientations()[k]);
      taken[k] = nanoseconds_since(start);
      check(appended);
    }
    benchmark::DoNotOptimize(curve(0.5 * (curve.available()->start + curve.available()->end)));
  }
  std::ranges::sort(taken);
  state.counters["p50"] = quantile(taken, 0.5);
  state.counters["p999"] = quantile(taken, 0.999);
  state.counters["most"] = taken.back();
}

}  // namespace

void ask_online(const Sizes& sizes) {
  const auto keys = std::make_shared<const Keyframes>(keys_of(random_track(sizes.setup_keys, 42)));
  benchmark::RegisterBenchmark("online/append", [keys](benchmark::State& state) { append_all(state, *keys); })
      ->Iterations(1)
      ->Repetitions(sizes.setup_repetitions);
}

}  // namespace orispline::bench
