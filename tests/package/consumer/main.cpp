// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include <orispline/orispline.hpp>

// A steady turn about z, 0.5 rad/s, through uneven keys: timed-c2 keeps the rate, so the curve in between is known.
int main() {
  constexpr double rate = 0.5, t = 1.7;
  orispline::KeyframeData data;
  for (const double time : {0.0, 1.0, 3.0, 3.5}) {
    data.times.push_back(time);
    data.orientations.emplace_back(Eigen::AngleAxisd(rate * time, Eigen::Vector3d::UnitZ()));
  }
  const auto curve = orispline::Keyframes::make(std::move(data)).and_then([](const orispline::Keyframes& keys) {
    return orispline::make_curve("timed-c2", keys);
  });
  if (!curve) {
    std::puts(orispline::describe(curve.error()).c_str());
    return 1;
  }
  const auto motion = curve->motion(t);
  const bool as_known = std::abs(motion.orientation.z() - std::sin(rate * t / 2.0)) < 1e-12 &&
                        (motion.angular_velocity - Eigen::Vector3d(0.0, 0.0, rate)).norm() < 1e-12;
  std::printf("orispline %s: q.z %.15g, w.z %.15g\n", orispline::version.data(), motion.orientation.z(),
              motion.angular_velocity.z());
  return as_known ? 0 : 1;
}
