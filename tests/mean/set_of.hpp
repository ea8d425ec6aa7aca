// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <random>
#include <vector>

#include <orispline/math/so3.hpp>
#include <orispline/mean.hpp>

namespace orispline::testing_support {

inline constexpr double degree = std::numbers::pi / 180.0;

/// Orientations that the tests make, with what belongs to them.
struct SetOf {
  std::vector<Eigen::Quaterniond> orientations{};
  std::vector<double> weights{};
  std::vector<Eigen::Vector3d> positions{};

  [[nodiscard]] OrientationSet view() const { return {orientations, positions, weights}; }
  [[nodiscard]] Expected<Mean> mean() const { return orispline::mean(view()); }
  [[nodiscard]] Expected<Mean> median() const { return orispline::mean(view(), {.kind = MeanKind::median}); }
};

/// Turns of a base by these rotation vectors in degrees, in its body frame.
inline SetOf turned(const Eigen::Quaterniond& base, const std::vector<Eigen::Vector3d>& degrees_of_turn) {
  SetOf set;
  for (const auto& turn : degrees_of_turn)
    set.orientations.push_back(base * exp<double>(Eigen::Vector3d(turn * degree)));
  return set;
}

inline Eigen::Vector3d normal_vector(std::mt19937_64& random, double deviation) {
  std::normal_distribution<double> normal(0.0, deviation);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

inline Eigen::Quaterniond any_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

inline const Eigen::Quaterniond base_pose = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized();

}  // namespace orispline::testing_support
