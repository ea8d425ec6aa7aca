// SPDX-License-Identifier: Apache-2.0
// What can this machine do at best? Products and sums, on one thread and on two, and writing memory.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <probes/probes.hpp>
#include <questions/questions.hpp>
#include <workload/buffer.hpp>
#include <workload/keys.hpp>

namespace orispline::bench {

namespace {

void fma_loop(benchmark::State& state, const FmaProbe& probe) {
  FmaWork work{0.999, 0.001, 20'000};
  double start = 1.5, sum = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(work);
    benchmark::DoNotOptimize(start);
    benchmark::DoNotOptimize(sum = probe.run(work, start));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(work.rounds * probe.chains));
}

void verify(const FmaProbe& probe) {
  const FmaWork work{0.999, 0.001, 1'000};
  const double found = probe.run(work, 1.5), wanted = fma_expected(probe, work, 1.5);
  if (!(std::abs(found - wanted) <= 1e-9 * std::abs(wanted))) give_up("the probe of products and sums leaves some out");
}

void write_everywhere(const std::string& name, void (*write)(std::span<double>, const double (&)[4]) noexcept,
                      const std::shared_ptr<Buffer<double>>& out) {
  measure("limit/" + name, out->all().size() / 4, [write, out] {
    double pattern[4] = {0.1, 0.2, 0.3, 0.4};
    benchmark::DoNotOptimize(pattern);
    write(out->all(), pattern);
    benchmark::DoNotOptimize(out->all().data());
  });
}

}  // namespace

void ask_limits(const Sizes& sizes, const char* isa) {
  const FmaProbe* probe = fma_probe(isa);
  if (!probe) give_up(std::string("there is no probe for the instruction set ") + isa);
  verify(*probe);
  benchmark::RegisterBenchmark("limit/fma", [probe](benchmark::State& state) { fma_loop(state, *probe); });
  for (const int threads : {1, 2})
    benchmark::RegisterBenchmark("limit/fma_on", [probe](benchmark::State& state) { fma_loop(state, *probe); })
        ->Threads(threads)
        ->UseRealTime();
  const auto out = std::make_shared<Buffer<double>>(4 * sizes.written);
  write_everywhere("write_plain", &write_plain, out);
  write_everywhere("write_streaming", &write_streaming, out);
}

}  // namespace orispline::bench
