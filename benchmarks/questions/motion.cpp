// SPDX-License-Identifier: Apache-2.0
// What does a single motion cost: the orientation with ω, α and jerk at one time, where the rates come from jets?
#include <benchmark/benchmark.h>

#include <memory>
#include <questions/questions.hpp>
#include <workload/buffer.hpp>
#include <workload/keys.hpp>
#include <workload/verify.hpp>

namespace orispline::bench {

void ask_motion(const Sizes& sizes) {
  const Track track = random_track(sizes.keys, 42);
  const EvenTimes t = even_times(track, sizes.samples.front());
  for (const char* method :
       {"squad", "shoemake", "circular", "barry-goldman", "tcb", "timed-c2"}) {  // jets but the last
    const std::string name = std::string("motion/") + method;
    const AnyCurve curve = curve_through(track, method);
    const auto out = std::make_shared<Buffer<double>>(4 * t.count);
    const auto run = [curve, t, out] {
      for (std::size_t k = 0; k < t.count; ++k) {
        Motion motion = curve.motion(t[k]);
        benchmark::DoNotOptimize(motion);
        Eigen::Vector4d::Map(&out->all()[4 * k]) = motion.orientation.coeffs();
      }
    };
    run();
    const double error =
        largest_error<double>(out->all(), Layout::interleaved, [&](std::size_t k) { return curve(t[k]).cast<Real>(); });
    accept(name + ", against the orientation alone", error, 4.0 * our_limit);
    measure(name, t.count, run);
  }
}

}  // namespace orispline::bench
