// SPDX-License-Identifier: Apache-2.0
// What a key and an evaluation of an online curve cost: every call timed by itself over a long stream of keys.
//
//   online_curve [METHOD [KEYS]]      timed-c2 and 1000000 keys unless told; prints ns
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <orispline/batch/online_curve.hpp>
#include <string>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

template <class Call>
float nanoseconds(Call call) {
  const Clock::time_point before = Clock::now();
  call();
  return std::chrono::duration<float, std::nano>(Clock::now() - before).count();
}

void print(const char* what, std::vector<float> ns) {
  std::sort(ns.begin(), ns.end());
  const auto quantile = [&ns](double share) {
    return static_cast<double>(ns[static_cast<std::size_t>(share * static_cast<double>(ns.size() - 1))]);
  };
  std::printf("%-34s %8.0f %8.0f %10.0f\n", what, quantile(0.5), quantile(0.999), quantile(1.0));
}

/// A tumbling body at 100 Hz, its clock uneven by up to a fifth.
double key_time(std::size_t i) { return 0.01 * (static_cast<double>(i) + 0.2 * std::sin(static_cast<double>(i))); }
Eigen::Quaterniond attitude(double t) {
  return orispline::exp(Eigen::Vector3d(2.0 * std::sin(3.0 * t), std::sin(5.0 * t + 1.0), 1.5 * std::cos(4.0 * t)));
}

/// What the loop itself costs: many evaluations between two readings of the clock.
template <class Evaluate>
void print_mean(const char* what, orispline::Domain domain, Evaluate evaluate) {
  constexpr int count = 1'000'000;
  double sum = 0.0;
  const float ns = nanoseconds([&] {
    for (int i = 0; i < count; ++i) {
      const double share = 0.61803398875 * i;
      sum += evaluate(domain.start + (domain.end - domain.start) * (share - std::floor(share)));
    }
  });
  std::printf("%-34s %8.1f   (checksum %.3f)\n", what, static_cast<double>(ns) / count, sum);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string method = argc > 1 ? argv[1] : "timed-c2";
  const std::size_t keys = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1'000'000;
  auto made = orispline::OnlineCurve::make(method, 64);
  if (!made || keys < 10) {
    std::fprintf(stderr, "%s\n", made ? "fewer than 10 keys" : describe(made.error()).c_str());
    return 2;
  }
  orispline::OnlineCurve& curve = *made;

  std::vector<float> clock(keys), append(keys), orientation(keys), motion(keys);
  double sum = 0.0;
  for (std::size_t i = 0; i < keys; ++i) {
    const double t = key_time(i);
    const Eigen::Quaterniond q = attitude(t);
    bool taken = false;
    append[i] = nanoseconds([&] { taken = curve.append(t, q).has_value(); });
    if (!taken) return 1;
    const double now = curve.available()->end - 0.0037;
    orientation[i] = nanoseconds([&] { sum += curve(now).w(); });
    motion[i] = nanoseconds([&] { sum += curve.motion(now).angular_acceleration.x(); });
    clock[i] = nanoseconds([] {});
  }
  std::printf("%s, %zu keys, capacity 64, checksum %.6f\n", method.c_str(), keys, sum);
  std::printf("%-34s %8s %8s %10s\n", "one call, the clock included [ns]", "p50", "p99.9", "max");
  print("clock alone", clock);
  print("append", append);
  print("orientation", orientation);
  print("motion (rates to the jerk)", motion);
  std::printf("mean of 1000000 at random times [ns]\n");
  print_mean("orientation", *curve.available(), [&](double t) { return curve(t).w(); });
  print_mean("motion", *curve.available(), [&](double t) { return curve.motion(t).angular_jerk.x(); });
}
