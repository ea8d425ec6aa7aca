// SPDX-License-Identifier: Apache-2.0
// Keys that arrive one by one at 10 Hz, a control loop at 1 kHz one key behind them: smooth across every arrival.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <orispline/streams.hpp>

Eigen::Quaterniond measured(double t) { return orispline::exp(Eigen::Vector3d(0.4 * t, 0.3 * t * t, 0.0)); }

int main() {
  auto curve = orispline::OnlineCurve::make("timed-c2", 16);  // a ring of 16 keys; from here on nothing is allocated
  if (!curve) return 1;
  const double delay = 0.2;  // a segment is final one key behind its end: two steps of 0.1 s behind the newest
  double largest_step = 0.0, last_speed = -1.0;
  for (int millisecond = 0; millisecond <= 1000; ++millisecond) {
    const double now = 0.001 * millisecond;
    if (millisecond % 100 == 0 && !curve->append(now, measured(now))) return 1;
    const auto available = curve->available();
    if (!available->contains(now - delay)) continue;
    const double speed = curve->motion(now - delay).angular_velocity.norm();
    if (last_speed >= 0.0) largest_step = std::max(largest_step, std::abs(speed - last_speed));
    last_speed = speed;
  }
  std::printf("available: %.1f s to %.1f s\n", curve->available()->start, curve->available()->end);
  std::printf("largest change of the speed in a millisecond: %.4f rad/s\n", largest_step);
  std::printf("%s\n", describe(curve->append(0.5, measured(0.5)).error()).c_str());
  if (!curve->finish()) return 1;
  std::printf("finished: %.1f s to %.1f s\n", curve->available()->start, curve->available()->end);
}
