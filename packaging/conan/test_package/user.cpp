// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <orispline/orispline.hpp>

/// Half of a quarter turn about z, by the package that was installed.
int main() {
  const auto quarter = orispline::quaternion_wxyz(0.5, 0.0, 0.0, 0.5);
  const auto start = orispline::quaternion_wxyz(1.0, 0.0, 0.0, 0.0);
  const auto keys = orispline::Keyframes::make({.times = {0.0, 1.0}, .orientations = {start, quarter.normalized()}});
  if (!keys) return std::puts(orispline::describe(keys.error()).c_str()), 1;
  const auto curve = orispline::make_curve("slerp", *keys);
  if (!curve) return std::puts(orispline::describe(curve.error()).c_str()), 1;
  const auto motion = curve->motion(0.5);
  std::printf("z: %.6f\n", motion.orientation.z());
  return motion.orientation.z() > 0.38 && motion.orientation.z() < 0.39 ? 0 : 1;
}
