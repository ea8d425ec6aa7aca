// SPDX-License-Identifier: Apache-2.0
// Exact angular velocity and acceleration, in the body frame and in the world, with chosen rates at both ends.

#include <cstdio>
#include <orispline/orispline.hpp>

void print(const char* what, const Eigen::Vector3d& v) {
  std::printf("  %-26s %8.4f %8.4f %8.4f\n", what, v.x(), v.y(), v.z());
}

int main() {
  orispline::KeyframeData data;
  data.times = {10.0, 10.8, 12.0, 12.5};
  for (const Eigen::Vector3d& attitude : {Eigen::Vector3d(0.0, 0.0, 0.3), Eigen::Vector3d(0.5, 0.2, 0.6),
                                          Eigen::Vector3d(1.1, -0.1, 0.9), Eigen::Vector3d(1.2, -0.4, 1.0)})
    data.orientations.push_back(orispline::exp(attitude));
  const auto keys = orispline::Keyframes::make(data);
  if (!keys) return 1;

  orispline::CurveOptions options;
  options.start = {.rule = orispline::EndRule::clamped, .angular_velocity = {0.2, 0.1, 0.4}};
  options.end.rule = orispline::EndRule::rest;
  const auto curve = orispline::make_curve({"timed-c2", options}, *keys);
  if (!curve) return 1;

  for (const double t : {10.0, 11.5}) {
    const orispline::Motion m = curve->motion(t);
    std::printf("t = %.1f s\n", t);
    print("velocity, body [rad/s]", m.angular_velocity);
    print("velocity, world [rad/s]", orispline::angular_velocity_world(m));
    print("acceleration, body", m.angular_acceleration);
    print("acceleration, world", orispline::angular_acceleration_world(m));
  }
  std::printf("it comes to rest: %.4f rad/s\n", curve->motion(12.5).angular_velocity.norm());
  std::printf("before 10 s it holds still: %.4f rad/s, or says so:\n", curve->motion(9.0).angular_velocity.norm());
  std::printf("%s\n", orispline::describe(curve->checked_motion(9.0).error()).c_str());
}
