// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <orispline/align.hpp>
#include <orispline/math/so3.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline::testing_support {

/// A body that turns about changing axes and goes round a room: a true motion, whose two recordings are made from it.
struct TrueMotion {
  static Eigen::Quaterniond orientation(double t) {
    return exp<double>(
               Eigen::Vector3d(0.9 * std::sin(1.1 * t), 0.7 * std::sin(1.7 * t + 0.4), 1.2 * std::sin(0.6 * t))) *
           exp<double>(Eigen::Vector3d(0.5 * std::cos(2.3 * t), 0.0, 0.3 * std::sin(3.1 * t)));
  }
  static Eigen::Vector3d position(double t) {
    return {2.0 * std::sin(0.7 * t), 1.5 * std::cos(0.9 * t) + 0.3 * t, 0.5 * std::sin(1.9 * t)};
  }
};

/// What makes the moved recording from the true motion, which the fixed one has: R′ = W R Bᵀ and p′ = s W p + d hold
/// with the moved one as R and p.
struct Difference {
  Eigen::Quaterniond world = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized();
  Eigen::Quaterniond body = Eigen::Quaterniond(0.8, 0.1, -0.3, 0.5).normalized();
  double offset = 0.1373;  // [s]
  double scale = 2.5;
  Eigen::Vector3d translation{10.0, -4.0, 1.5};
};

/// How a recording is taken.
struct Taken {
  double rate = 50.0, from = 0.0, to = 20.0;  // [Hz], [s]
  double noise = 0.0, position_noise = 0.0;   // σ per axis [rad], [m]
  double wild = 0.0;                          // the share of samples that say anything
  bool has_positions = false;
};

inline Eigen::Vector3d normal_vector(std::mt19937_64& random, double deviation) {
  std::normal_distribution<double> normal(0.0, 1.0);
  const double x = normal(random), y = normal(random), z = normal(random);
  return deviation * Eigen::Vector3d(x, y, z);
}

using Orientation = std::function<Eigen::Quaterniond(double)>;
using Position = std::function<Eigen::Vector3d(double)>;

inline Track track_of(const Taken& taken, double late, const Orientation& orientation, const Position& position,
                      std::mt19937_64& random) {
  KeyframeData data;
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto count = static_cast<std::size_t>((taken.to - taken.from) * taken.rate);
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = taken.from + static_cast<double>(i) / taken.rate;
    data.times.push_back(t + late);
    const bool is_wild = share(random) < taken.wild;
    const Eigen::Vector3d turn = normal_vector(random, is_wild ? 1.5 : taken.noise);
    data.orientations.push_back(orientation(t) * exp<double>(turn));
    const Eigen::Vector3d jump = normal_vector(random, is_wild ? 1.0 : taken.position_noise);
    if (taken.has_positions) data.positions.push_back(position(t) + jump);
  }
  return Keyframes::make(std::move(data)).value();
}

inline Track fixed_recording(const Taken& taken, std::mt19937_64& random) {
  return track_of(taken, 0.0, TrueMotion::orientation, TrueMotion::position, random);
}

inline Track moved_recording(const Taken& taken, const Difference& d, std::mt19937_64& random) {
  const auto orientation = [&](double t) { return d.world.conjugate() * TrueMotion::orientation(t) * d.body; };
  const auto position = [&](double t) -> Eigen::Vector3d {
    return to_body<double>(d.world, Eigen::Vector3d(TrueMotion::position(t) - d.translation)) / d.scale;
  };
  return track_of(taken, d.offset, orientation, position, random);
}

}  // namespace orispline::testing_support
