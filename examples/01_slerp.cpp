// SPDX-License-Identifier: Apache-2.0
// Two orientations: how far apart they are, what lies between them, and which way round the motion goes.

#include <cstdio>
#include <numbers>
#include <orispline/orispline.hpp>

int main() {
  constexpr double degree = std::numbers::pi / 180.0;
  const Eigen::Vector3d sixty_degrees_about_x(60.0 * degree, 0.0, 0.0);
  const Eigen::Quaterniond level = orispline::quaternion_wxyz(1.0, 0.0, 0.0, 0.0);
  const Eigen::Quaterniond banked = orispline::exp(sixty_degrees_about_x);

  std::printf("apart %.1f deg\n", orispline::angular_distance(level, banked) / degree);
  for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Eigen::Quaterniond q = orispline::slerp(level, banked, s);
    std::printf("s %.2f  w %.6f  x %.6f  bank %.1f deg\n", s, q.w(), q.x(), orispline::log(q).x() / degree);
  }

  // q and -q are one orientation, but slerp takes the signs that it is given: here it goes the long way round.
  const Eigen::Quaterniond other_sign(-banked.coeffs());
  const Eigen::Vector3d long_way = orispline::increment(level, other_sign);
  std::printf("still %.1f deg apart, yet the long way is %.1f deg about -x\n",
              orispline::angular_distance(level, other_sign) / degree, -long_way.x() / degree);
}
