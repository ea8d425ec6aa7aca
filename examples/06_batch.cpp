// SPDX-License-Identifier: Apache-2.0
// Many samples at once: a track resampled into the caller's memory, on as many threads as wanted, with the same bits.

#include <cstdio>
#include <orispline/orispline.hpp>
#include <orispline/sampling.hpp>

int main() {
  orispline::KeyframeData data;
  for (int i = 0; i < 1000; ++i) {
    data.times.push_back(0.1 * i);
    data.orientations.push_back(orispline::exp(Eigen::Vector3d(0.3 * (i % 3), 0.01 * i, 0.2 * (i % 7))));
  }
  const auto curve = orispline::make_curve("timed-c2", orispline::Keyframes::make(data).value());
  if (!curve) return 1;

  const std::size_t count = 100'000;
  std::vector<double> orientations(4 * count), velocities(3 * count);  // qx, qy, qz, qw; body rates [rad/s]
  const auto sampled = orispline::sample_uniform<double>(
      *curve, 0.0, 0.001, {.orientations = orientations, .angular_velocities = velocities}, {.threads = 2});
  if (!sampled) return 1;

  const orispline::CompiledCurve<float> replayed(*curve);  // for many calls: all segments made ready once
  const std::vector<double> times{70.0, 3.5, 99.9};        // in any order
  std::vector<float> some(4 * times.size());
  if (!orispline::sample_at<float>(replayed, times, {.orientations = some})) return 1;

  const std::size_t k = 70'000;
  std::printf("sample %zu of %zu: w %.6f, rate %.6f rad/s\n", k, count, orientations[4 * k + 3], velocities[3 * k]);
  std::printf("the same in float: w %.6f\n", static_cast<double>(some[3]));
  const orispline::Motion m = curve->motion(static_cast<double>(k) * 0.001);
  std::printf("one by one:        w %.6f, rate %.6f rad/s\n", m.orientation.w(), m.angular_velocity.x());
}
