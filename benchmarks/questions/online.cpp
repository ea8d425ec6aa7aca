// SPDX-License-Identifier: Apache-2.0
// What does a key cost in a stream, in the worst of many cases? Every append is timed by itself, less the time of
// reading the clock twice: the median of as many readings with nothing between them, taken in turn with the appends.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <orispline/online/online_curve.hpp>
#include <questions/questions.hpp>
#include <workload/keys.hpp>

namespace orispline::bench {

namespace {

template <class Call>
double nanoseconds(Call call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

double quantile(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

void append_all(benchmark::State& state, const Keyframes& keys) {
  std::vector<double> taken(keys.size()), clock(keys.size());  // touched here, not while the clock runs
  for ([[maybe_unused]] auto _ : state) {
    OnlineCurve curve = value_or_give_up(OnlineCurve::make("timed-c2", 1000));
    for (std::size_t k = 0; k < keys.size(); ++k) {
      bool appended = false;
      double time = keys.times()[k];  // a key that has come, not one to be fetched while the clock runs
      Eigen::Quaterniond orientation = keys.orientations()[k];
      benchmark::DoNotOptimize(time);
      benchmark::DoNotOptimize(orientation);
      clock[k] = nanoseconds([] {});
      taken[k] = nanoseconds([&] { appended = curve.append(time, orientation).has_value(); });
      if (!appended) give_up("an online curve refused a key");
    }
    benchmark::DoNotOptimize(curve(0.5 * (curve.available()->start + curve.available()->end)));
  }
  std::ranges::sort(taken);
  std::ranges::sort(clock);
  const double reading = quantile(clock, 0.5);
  state.counters["clock"] = reading;
  state.counters["p50"] = quantile(taken, 0.5) - reading;
  state.counters["p999"] = quantile(taken, 0.999) - reading;
  state.counters["most"] = taken.back() - reading;
}

}  // namespace

void ask_online(const Sizes& sizes) {
  const auto keys = std::make_shared<const Keyframes>(keys_of(random_track(sizes.setup_keys, 42)));
  benchmark::RegisterBenchmark("online/append", [keys](benchmark::State& state) { append_all(state, *keys); })
      ->Iterations(1)
      ->Repetitions(sizes.setup_repetitions);
}

}  // namespace orispline::bench
