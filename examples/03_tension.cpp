// SPDX-License-Identifier: Apache-2.0
// One tension per key: how fast the motion passes the key in the middle, while the others stay as they are.

#include <cstdio>
#include <orispline/orispline.hpp>

int main() {
  orispline::KeyframeData data;
  data.times = {0.0, 1.0, 2.0, 3.0, 4.0};
  for (const double yaw : {0.0, 0.4, 0.8, 1.2, 1.6})  // [rad]: a steady pan
    data.orientations.push_back(orispline::exp(Eigen::Vector3d(0.0, 0.0, yaw)));
  const auto keys = orispline::Keyframes::make(data);
  if (!keys) return 1;

  std::printf("tension   yaw rate [rad/s] at t = 1.0     1.5     2.0     2.5     3.0 s\n");
  for (const double tension : {1.0, 0.5, 0.0, -0.2}) {
    orispline::CurveOptions options;
    options.parameters["tension"] = {0.5, 0.5, tension, 0.5, 0.5};  // one per key; a single value would serve for all
    const auto curve = orispline::make_curve({"timed-c2", options}, *keys);
    if (!curve) return 1;
    std::printf("%7.1f                          ", tension);
    for (const double t : {1.0, 1.5, 2.0, 2.5, 3.0}) std::printf(" %7.4f", curve->motion(t).angular_velocity.z());
    std::printf("\n");
  }

  orispline::CurveOptions wrong;
  wrong.parameters["tension"] = {0.5, 0.5};
  std::printf("%s\n", orispline::describe(orispline::make_curve({"timed-c2", wrong}, *keys).error()).c_str());
}
