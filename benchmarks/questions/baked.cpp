// SPDX-License-Identifier: Apache-2.0
// What does a sample of a baked curve cost, beside the curve itself? That of rational is made of polynomials already.
#include <benchmark/benchmark.h>

#include <memory>
#include <questions/questions.hpp>
#include <workload/buffer.hpp>
#include <workload/keys.hpp>
#include <workload/verify.hpp>

namespace orispline::bench {

namespace {

constexpr double tolerance = 1e-9, float_tolerance = 1e-6;  // [rad]

/// Verified against the scalar evaluator on the first call, then timed.
template <class T, class Curve>
void enter(const std::string& name, const AnyCurve& truth, const Curve& curve, const EvenTimes& t, double limit) {
  const auto out = std::make_shared<Buffer<T>>(4 * t.count);
  const auto run = [curve, t, out] {
    check(sample_uniform<T>(curve, t.t0, t.dt, Samples<T>{.orientations = out->all()}));
    benchmark::DoNotOptimize(out->all().data());
  };
  run();
  accept(name,
         largest_error<T>(out->all(), Layout::interleaved, [&](std::size_t k) { return truth(t[k]).cast<Real>(); }),
         limit);
  measure(name, t.count, run);
}

}  // namespace

void ask_baked(const Sizes& sizes) {
  const Track track = random_track(sizes.keys, 42);
  const EvenTimes t = even_times(track, std::min<std::size_t>(sizes.samples.back(), 1'000'000));
  for (const char* method : {"rational", "timed-c2", "squad"}) {
    const std::string name = std::string("baked/") + method;
    const AnyCurve curve = curve_through(track, method);
    const auto baked = bake(curve, tolerance);
    const auto baked_float = bake<float>(curve, float_tolerance);
    if (!baked || !baked_float) give_up(name + ": " + describe(baked ? baked_float.error() : baked.error()));
    enter<double>(name + "/itself", curve, curve, t, tolerance);
    enter<double>(name + "/baked", curve, *baked, t, tolerance);
    enter<float>(name + "/baked float", curve, *baked_float, t, float_tolerance);
  }
}

}  // namespace orispline::bench
