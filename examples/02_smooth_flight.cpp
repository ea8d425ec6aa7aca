// SPDX-License-Identifier: Apache-2.0
// A turn, a pull-up and a roll through five keys at uneven times: which methods are smooth in time?

#include <cstdio>
#include <numbers>
#include <orispline/orispline.hpp>

int main() {
  constexpr double degree = std::numbers::pi / 180.0;
  const auto turned_by = [](double x, double y, double z) { return orispline::exp(Eigen::Vector3d(x, y, z)); };

  orispline::KeyframeData data;
  data.times = {0.0, 1.0, 1.5, 3.5, 4.5};  // [s]
  data.orientations = {turned_by(0.0, 0.0, 0.0)};
  for (const Eigen::Quaterniond& step : {turned_by(0.0, 0.0, 40.0 * degree), turned_by(0.0, -30.0 * degree, 0.0),
                                         turned_by(110.0 * degree, 0.0, 0.0), turned_by(50.0 * degree, 0.0, 0.0)})
    data.orientations.push_back(data.orientations.back() * step);  // body frame: the step stands on the right

  const auto keys = orispline::Keyframes::make(data);
  if (!keys) return std::fprintf(stderr, "%s\n", orispline::describe(keys.error()).c_str()), 1;

  std::printf("method        turn rate before and after the key at 1.5 s\n");
  for (const char* method : {"slerp", "squad", "quintic", "sextic", "timed-c2", "auto"}) {
    const auto curve = orispline::make_curve(method, *keys);
    if (!curve) return std::fprintf(stderr, "%s\n", orispline::describe(curve.error()).c_str()), 1;
    const orispline::Motion before = curve->motion(1.5, orispline::Side::left), after = curve->motion(1.5);
    std::printf("%-12s  %7.3f  %7.3f rad/s\n", method, before.angular_velocity.norm(), after.angular_velocity.norm());
  }
}
