// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstdio>

#include <orispline/orispline.hpp>
#include <orispline/sampling.hpp>
#include <orispline/streams.hpp>

namespace {

constexpr double rate = 0.5, when = 1.7;

bool is_as_known(const orispline::Motion& motion) {
  return std::abs(motion.orientation.z() - std::sin(rate * when / 2.0)) < 1e-12 &&
         (motion.angular_velocity - Eigen::Vector3d(0.0, 0.0, rate)).norm() < 1e-12;
}

bool can_run_this() {
#ifdef __AVX2__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

/// A steady turn about z through uneven keys.
orispline::KeyframeData steady_turn() {
  orispline::KeyframeData data;
  for (const double time : {0.0, 1.0, 3.0, 3.5}) {
    data.times.push_back(time);
    data.orientations.emplace_back(Eigen::AngleAxisd(rate * time, Eigen::Vector3d::UnitZ()));
  }
  return data;
}

orispline::Expected<orispline::AnyCurve> curve_through(const orispline::KeyframeData& data) {
  return orispline::Keyframes::make(data).and_then(
      [](const orispline::Keyframes& keys) { return orispline::make_curve("timed-c2", keys); });
}

/// The same, key by key: the keys are structs, whose layout hangs on the alignment of Eigen's types.
bool is_as_known_online(const orispline::KeyframeData& data) {
  auto curve = orispline::OnlineCurve::make("timed-c2", 8);
  if (!curve) return false;
  for (std::size_t i = 0; i < data.times.size(); ++i)
    if (!curve->append({.time = data.times[i], .orientation = data.orientations[i]})) return false;
  return curve->finish() && is_as_known(curve->motion(when));
}

}  // namespace

// timed-c2 keeps the rate, so the curve in between is known.
int main() {
  if (!can_run_this()) return std::puts("not run: this processor has not what the program was compiled for"), 0;
  const auto data = steady_turn();
  const auto curve = curve_through(data);
  if (!curve) return std::puts(orispline::describe(curve.error()).c_str()), 1;
  const auto motion = curve->motion(when);
  const auto checked = curve->checked_motion(when);
  std::array<double, 8> numbers{};  // of two samples: qx, qy, qz, qw
  const bool sampled =
      orispline::sample(*curve, std::array{0.0, when}, orispline::Samples<double>{.orientations = numbers}).has_value();
  std::printf("orispline %s: q.z %.15g, w.z %.15g\n", orispline::version.data(), motion.orientation.z(),
              motion.angular_velocity.z());
  const bool as_known = is_as_known(motion) && checked && is_as_known(*checked) && !curve->checked_motion(-1.0) &&
                        is_as_known_online(data) && sampled && std::abs(numbers[6] - motion.orientation.z()) < 1e-12;
  return as_known ? 0 : 1;
}
