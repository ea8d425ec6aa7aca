// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include <orispline/clip/clip.hpp>

// Skeletons and clips that are made by formulas.

namespace orispline::testing_support {

inline Eigen::Quaterniond turned(double x, double y, double z) { return exp<double>(Eigen::Vector3d(x, y, z)); }

inline Skeleton two_joints() {
  return Skeleton::make({{.name = "hips"}, {.name = "leg", .parent = 0, .rest = {.translation = {0.0, -0.5, 0.0}}}})
      .value();
}

/// Keys at uneven times with unit values; of cubics with tangents that no other curve has.
inline RotationChannel random_rotations(unsigned seed, ChannelInterpolation interpolation, double widest = 1.0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  RotationChannel channel{.joint = 1, .interpolation = interpolation};
  double time = 0.25;
  Eigen::Quaterniond value = turned(number(random), number(random), number(random));
  for (int i = 0; i < 7; ++i) {
    channel.times.push_back(time);
    channel.values.push_back(value);
    if (interpolation == ChannelInterpolation::cubicspline) {
      const auto tangent = [&] {
        return Eigen::Quaterniond(Eigen::Vector4d(number(random), number(random), number(random), number(random)));
      };
      channel.in_tangents.push_back(tangent());
      channel.out_tangents.push_back(tangent());
    }
    time += 0.3 + 0.2 * number(random);
    value = (value * turned(widest * number(random), widest * number(random), widest * number(random))).normalized();
  }
  return channel;
}

inline VectorChannel random_vectors(unsigned seed, ChannelInterpolation interpolation) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&] { return Eigen::Vector3d(number(random), number(random), number(random)); };
  VectorChannel channel{.joint = 0, .interpolation = interpolation};
  for (double time = 0.25; channel.size() < 7; time += 0.3 + 0.2 * number(random)) {
    channel.times.push_back(time);
    channel.values.push_back(vector());
    if (interpolation != ChannelInterpolation::cubicspline) continue;
    channel.in_tangents.push_back(vector());
    channel.out_tangents.push_back(vector());
  }
  return channel;
}

/// A step of a walk: `rounds` swings of the leg in a second each, at 30 keys a second, while the hips go ahead, turn
/// about y and bounce.
inline Clip walk(double rounds, double drift, double heading, int keys_a_second = 30) {
  constexpr double tau = 6.283185307179586;
  RotationChannel leg{.joint = 1}, hips{.joint = 0};
  VectorChannel path{.joint = 0};
  const int count = static_cast<int>(std::lround(rounds * keys_a_second));
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / keys_a_second;
    leg.times.push_back(t);
    leg.values.push_back(turned(0.8 * std::sin(tau * t) + drift * t, 0.2 * std::cos(tau * t), drift * t * t));
    hips.values.push_back(turned(0.0, heading * t, 0.0) *
                          turned(0.05 * std::sin(2.0 * tau * t), 0.0, 0.1 * std::sin(tau * t)));
    const double about = heading == 0.0 ? t : std::sin(heading * t) / heading;  // of a straight line, else of a circle
    const double across = heading == 0.0 ? 0.0 : (std::cos(heading * t) - 1.0) / heading;
    const Eigen::Vector3d sway = turned(0.0, heading * t, 0.0) * Eigen::Vector3d(0.0, 0.0, 0.1 * std::sin(tau * t));
    path.values.push_back(
        Eigen::Vector3d(1.2 * about, 0.9 + 0.03 * std::cos(2.0 * tau * t) + 0.01 * drift * t, 1.2 * across) + sway);
  }
  hips.times = path.times = leg.times;
  return {.name = "walk", .rotations = {hips, leg}, .translations = {path}};
}

/// Hips and a leg below a node.
inline Skeleton below_node(const JointPose& node = {}) {
  return Skeleton::make({{.name = "node", .rest = node},
                         {.name = "hips", .parent = 0},
                         {.name = "leg", .parent = 1, .rest = {.translation = {0.0, -0.5, 0.0}}}})
      .value();
}

/// The walk with its way in the node above, beside which the hips only sway: they lean about x.
inline Clip walk_of_node(double heading) {
  Clip clip = walk(1.0, 0.2, heading);
  clip.rotations[1].joint = 2;
  RotationChannel hips{.joint = 1, .times = clip.rotations[0].times};
  for (const double t : hips.times) hips.values.push_back(turned(0.1 * t, 0.0, 0.0));
  clip.rotations.push_back(hips);
  return clip;
}

}  // namespace orispline::testing_support
