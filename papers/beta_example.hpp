// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/curve/cumulative_bezier.hpp>

#include "papers/experiment.hpp"

namespace orispline::cli {

inline constexpr double beta1 = 1.0, beta2 = 0.5;  // of both examples, at every point

/// The Beta curve of an example; times and local parameters have the same scale.
struct BetaExample {
  Keyframes keys;
  CubicBezierCurve curve;
};

struct NamedExample {
  std::string signs;
  BetaExample example;
};

/// Example 2 with one value of β₂ at point 1.
struct Variant {
  double beta2_of_point1;
  std::string_view color;
  std::vector<NamedExample> examples;  ///< signs as given, shortest signs
};

/// Where the segments meet, and the ends.
[[nodiscard]] std::vector<Eigen::Quaterniond> joints_of(const BetaExample& example);

/// Figures 1, 2 and 3.
[[nodiscard]] std::vector<Picture> example1_pictures(const BetaExample& example);

/// Figure 4.
[[nodiscard]] Picture effect_picture(const std::vector<Variant>& all);

}  // namespace orispline::cli
