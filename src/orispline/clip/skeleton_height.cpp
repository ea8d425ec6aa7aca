// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <orispline/base/formatted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/motion_file.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double lowest = 0.3, highest = 3.0, usual = 1.7;  // [m]

struct LengthUnit {
  double metres;
  std::string_view name;
};
constexpr std::array length_units{LengthUnit{0.01, "centimetres"}, LengthUnit{0.0254, "inches"},
                                  LengthUnit{0.001, "millimetres"}, LengthUnit{0.3048, "feet"},
                                  LengthUnit{1.0, "metres"}};

/// How large the skeleton is at rest, along the axis of the world along which it is largest.
double largest_extent(const Skeleton& skeleton) {
  Eigen::Array3d least = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity()), most = -least;
  for (const Eigen::Affine3d& pose : world_poses(skeleton, Clip{}, std::array{0.0})) {
    least = least.min(pose.translation().array());
    most = most.max(pose.translation().array());
  }
  return skeleton.size() == 0 ? 0.0 : (most - least).maxCoeff();
}

bool is_of_person(double height) { return height >= lowest && height <= highest; }

/// `; the `position_scale` 0.0254 makes it 1.8 m, as it is if the file is in inches`
std::string cure_for(double extent) {
  const auto off = [extent](const LengthUnit& unit) {
    return std::abs(elementary::natural_logarithm(extent * unit.metres / usual));
  };
  const LengthUnit& nearest = *std::ranges::min_element(length_units, {}, off);
  if (!is_of_person(extent * nearest.metres)) return "; `position_scale` says how many metres a unit of the file is";
  return formatted("; the `position_scale` {:g} makes it {:.3g} m, as it is if the file is in {}", nearest.metres,
                   extent * nearest.metres, nearest.name);
}

}  // namespace

std::vector<Warning> warnings_of_height(const Skeleton& skeleton, const ClipFormat& format, double metres,
                                        const std::string& made) {
  if (!format.has_no_unit) return {};
  const double extent = largest_extent(skeleton);
  if (!(extent > 0.0) || is_of_person(extent * metres)) return {};
  return {{.code = "unlikely_height",
           .message = formatted("the skeleton is {:.4g} m large at rest{}", extent * metres, cure_for(extent)),
           .where = {.file = made},
           .numbers = {{"height_m", extent * metres}}}};
}

}}  // namespace orispline
