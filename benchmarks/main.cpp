// SPDX-License-Identifier: Apache-2.0
// orispline_bench [--sizes=full|quick|smoke] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <orispline/batch/kernel/dispatch.hpp>
#include <questions/questions.hpp>
#include <workload/keys.hpp>

namespace orispline::bench {

void measure(const std::string& name, std::size_t items, std::function<void()> work) {
  benchmark::RegisterBenchmark(name.c_str(), [items, work = std::move(work)](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      work();
      benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
  });
}

namespace {

const std::map<std::string, Sizes, std::less<>> all_sizes{
    {"full",
     {10'000'000,
      1'000,
      {10'000, 1'000'000, 10'000'000},
      {2, 8, 32, 128, 1'000},
      {10'000, 100'000},
      200'000,
      1'000'000,
      5}},
    {"quick", {10'000'000, 1'000, {10'000, 1'000'000}, {2, 8, 32, 128, 1'000}, {10'000}, 100'000, 100'000, 3}},
    {"smoke", {10'000, 20, {500, 2'000}, {2, 8}, {100}, 1'000, 1'000, 1}}};

/// Takes `--sizes=…` out of the arguments.
Sizes sizes_from(int& count, char** arguments) {
  std::string name = "quick";
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    if (std::strncmp(arguments[i], "--sizes=", 8) == 0) name = arguments[i] + 8;
    else arguments[kept++] = arguments[i];
  }
  count = kept;
  const auto found = all_sizes.find(name);
  if (found == all_sizes.end()) give_up("the sizes are '" + name + "', wanted full, quick or smoke");
  return found->second;
}

void ask_everything(const Sizes& sizes) {
  const char* isa = batch::kernels().name;
  Errors errors;
  ask_limits(sizes, isa);
  ask_one_curve(sizes, errors);
  ask_rates(sizes, errors);
  ask_samples_per_segment(sizes, errors);
  ask_many_curves(sizes, errors);
  ask_random_access(sizes, errors);
  ask_setup(sizes);
  ask_auto(sizes);
  ask_baked(sizes);
  ask_motion(sizes);
#if defined(ORISPLINE_BENCH_ONLINE)
  ask_online(sizes);
#endif
  const auto state = [](const char* name, double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    benchmark::AddCustomContext(name, text);
  };
  state("max_error_double", errors.in_double);
  state("max_error_float", errors.in_float);
  benchmark::AddCustomContext("isa", isa);
  benchmark::AddCustomContext("contraction", ORISPLINE_BENCH_CONTRACTION ? "true" : "false");
  benchmark::AddCustomContext("compiler", ORISPLINE_BENCH_COMPILER);
}

}  // namespace

}  // namespace orispline::bench

int main(int count, char** arguments) {
  const orispline::bench::Sizes sizes = orispline::bench::sizes_from(count, arguments);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  orispline::bench::ask_everything(sizes);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
