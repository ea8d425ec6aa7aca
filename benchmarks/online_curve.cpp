// SPDX-License-Identifier: Apache-2.0
// What a key and an evaluation of an online curve cost: every append timed by itself over a long stream of keys.
//
//   orispline_online [METHOD|all [KEYS]]      all and 1000000 keys unless told; prints ns
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <orispline/online/online_curve.hpp>
#include <string>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using orispline::Domain;
using orispline::OnlineCurve;

template <class Call>
double nanoseconds(Call call) {
  const Clock::time_point before = Clock::now();
  call();
  return std::chrono::duration<double, std::nano>(Clock::now() - before).count();
}

/// A tumbling body at 100 Hz, its clock uneven by up to a fifth.
struct Keys {
  std::vector<double> times;
  std::vector<Eigen::Quaterniond> orientations;

  explicit Keys(std::size_t count) : times(count), orientations(count) {
    for (std::size_t i = 0; i < count; ++i) {
      const double k = static_cast<double>(i), t = times[i] = 0.01 * (k + 0.2 * std::sin(k));
      orientations[i] =
          orispline::exp(Eigen::Vector3d(2.0 * std::sin(3.0 * t), std::sin(5.0 * t + 1.0), 1.5 * std::cos(4.0 * t)));
    }
  }
};

struct Quantiles {
  double p50, p999, most;

  /// `taken` may hold them in any order.
  [[nodiscard]] static Quantiles of(std::vector<float> taken) {
    std::sort(taken.begin(), taken.end());
    const auto at = [&](double share) {
      return static_cast<double>(taken[static_cast<std::size_t>(share * static_cast<double>(taken.size() - 1))]);
    };
    return {at(0.5), at(0.999), at(1.0)};
  }
};

/// Times of calls [ns]; its memory is touched by construction.
struct Stream {
  std::vector<float> clock, append, orientation, motion;
  explicit Stream(std::size_t keys) : clock(keys), append(keys), orientation(keys), motion(keys) {}

  /// Returns whether all keys were taken.
  [[nodiscard]] bool run(OnlineCurve& curve, const Keys& keys) {
    double sum = 0.0;
    bool all_taken = true;
    for (std::size_t i = 0; i < keys.times.size(); ++i) {
      bool taken = false;
      clock[i] = static_cast<float>(nanoseconds([] {}));
      append[i] = static_cast<float>(
          nanoseconds([&] { taken = curve.append(keys.times[i], keys.orientations[i]).has_value(); }));
      all_taken = all_taken && taken;
      const double now = curve.available()->end - 0.0037;
      orientation[i] = static_cast<float>(nanoseconds([&] { sum += curve(now).w(); }));
      motion[i] = static_cast<float>(nanoseconds([&] { sum += curve.motion(now).angular_acceleration.x(); }));
    }
    return all_taken && std::isfinite(sum);
  }
};

/// What a loop costs: evaluations at times all over what is kept, each of which waits for the one before. The median
/// over many stretches far shorter than the turns of the scheduler.
template <class Evaluate>
double mean(Domain domain, Evaluate evaluate) {
  constexpr int stretches = 1'001, count = 500;
  double nothing = 0.0;
  std::vector<float> taken;
  for (int stretch = 0; stretch < stretches; ++stretch)
    taken.push_back(static_cast<float>(nanoseconds([&] {
      for (int i = 0; i < count; ++i) {
        const double share = 0.61803398875 * i;
        nothing = 1e-300 * evaluate(domain.start + (domain.end - domain.start) * (share - std::floor(share)) + nothing);
      }
    })));
  return std::isfinite(nothing) ? Quantiles::of(taken).p50 / count : -1.0;
}

bool measure(std::string_view method, const Keys& keys, Stream& stream) {
  auto curve = OnlineCurve::make(method, 64);
  if (!curve) return std::fprintf(stderr, "%s\n", describe(curve.error()).c_str()), false;
  if (!stream.run(*curve, keys)) return std::fprintf(stderr, "a key was refused\n"), false;
  const Quantiles append = Quantiles::of(stream.append), orientation = Quantiles::of(stream.orientation),
                  motion = Quantiles::of(stream.motion);
  const double clock = Quantiles::of(stream.clock).p50;
  const Domain domain = *curve->available();
  std::printf("%-13.*s %6.0f %6.0f %6.0f %9.0f %6.0f %6.0f %6.0f %6.0f %9.1f %9.1f\n", static_cast<int>(method.size()),
              method.data(), clock, append.p50 - clock, append.p999 - clock, append.most - clock,
              orientation.p50 - clock, orientation.p999 - clock, motion.p50 - clock, motion.p999 - clock,
              mean(domain, [&](double t) { return (*curve)(t).w(); }),
              mean(domain, [&](double t) { return curve->motion(t).angular_jerk.x(); }));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string chosen = argc > 1 ? argv[1] : "all";
  const std::size_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1'000'000;
  if (count < 10) return std::fprintf(stderr, "fewer than 10 keys\n"), 2;
  const Keys keys(count);
  Stream stream(count);
  std::printf("%zu keys, capacity 64; single calls less the p50 of the clock alone, means of 500 [ns]\n", count);
  std::printf("%-13s %6s %23s %13s %13s %19s\n", "", "clock", "append", "orientation", "motion", "mean of");
  std::printf("%-13s %6s %6s %6s %9s %6s %6s %6s %6s %9s %9s\n", "method", "p50", "p50", "p99.9", "max", "p50", "p99.9",
              "p50", "p99.9", "orient.", "motion");
  if (chosen != "all") return measure(chosen, keys, stream) ? 0 : 2;
  for (const std::string_view method : OnlineCurve::methods())
    if (!measure(method, keys, stream)) return 2;
}
