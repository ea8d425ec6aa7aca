// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fuzz/fuzzed_keys.hpp>
#include <orispline/families/registry.hpp>
#include <support/specimens.hpp>

namespace orispline::fuzz {

/// The motion through the keys as a sensor records it: 20 to 147 even samples with noise, some of them astray, with the
/// rates of a gyro that has a bias. The bytes of no recording are zeros; then the keys are the samples themselves.
[[nodiscard]] inline Expected<Keyframes> fuzzed_recording(FuzzInput& input, const Keyframes& keys) {
  Flags flags(input);
  const bool records = flags.next(), has_outliers = flags.next(), has_gyro = flags.next(), is_still = flags.next();
  const std::size_t count = 20 + input.byte() / 2u, seed = input.byte();
  const double noise = std::pow(10.0, -static_cast<double>(input.below(9)));  // [rad]
  if (!records || keys.size() < 2) return keys;
  return make_pose_curve(default_method, keys).and_then([&](const PoseCurve& curve) {
    testing_support::Dice dice(seed);
    const Domain domain = curve.orientation.domain();
    KeyframeData data;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count - 1);
      const double t = domain.start + share * (domain.end - domain.start);
      // A recording that stands still at both ends, as most do.
      const double at =
          is_still ? domain.start + std::clamp(2.0 * share - 0.5, 0.0, 1.0) * (domain.end - domain.start) : t;
      const Motion m = curve.orientation.motion(at);
      const double size = has_outliers && dice() < 0.03 ? 0.3 : noise;
      data.times.push_back(t);
      data.orientations.push_back(m.orientation * exp<double>(size * dice.vector()));
      if (has_gyro)
        data.angular_velocities.push_back(m.angular_velocity + Eigen::Vector3d(0.01, -0.02, 0.03) +
                                          noise * dice.vector());
      if (curve.position) data.positions.push_back(curve.position->linear_motion(at).position + noise * dice.vector());
    }
    return Keyframes::make(std::move(data));
  });
}

}  // namespace orispline::fuzz
