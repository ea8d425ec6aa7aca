// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/clip_reduction_fields.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/fields/field.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr Interval positive_or_none{positive.lowest, std::numeric_limits<double>::infinity()};

}  // namespace

template <>
std::span<const FieldInfo> fields_of<ClipReduceOptions>() noexcept {
  static constexpr std::array fields{
      field<&ClipReduceOptions::tolerance>(
          {.name = "tolerance",
           .sentence = "Largest angle that is allowed between a joint and its key before, in the frame of its parent",
           .quantity = &quantities::angle,
           .range = positive_or_none,
           .example = "0.1deg or 2e-3rad",
           .absent = "angles are not bounded"}),
      field<&ClipReduceOptions::position_tolerance>(
          {.name = "position_tolerance",
           .sentence = "Largest distance that is allowed between a joint's translation and its key before",
           .quantity = &quantities::length,
           .range = positive_or_none,
           .absent = "translations stay as they are"}),
      field<&ClipReduceOptions::world_tolerance>(
          {.name = "world_tolerance",
           .sentence = "Largest distance that points of a skeleton's joints may be off in the world, in its clips",
           .quantity = &quantities::length,
           .range = positive_or_none,
           .absent = "places in the world are not bounded"}),
      field<&ClipReduceOptions::shell>(
          {.name = "shell",
           .sentence = "Distance from a joint of the points that are compared in the world",
           .quantity = &quantities::length,
           .range = positive,
           .example = "3cm",
           .absent = "3cm"}),
      field<&ClipReduceOptions::between>(
          {.name = "between", .sentence = "What the motion of a clip between its keys is taken to be"}),
  };
  return fields;
}

std::string tolerance_text(const ClipReduceOptions& options, double metres, std::string_view unit) {
  std::vector<std::string> parts;
  if (std::isfinite(options.tolerance)) parts.push_back(formatted("{:.6g}°", options.tolerance * degrees));
  if (std::isfinite(options.position_tolerance))
    parts.push_back(formatted("{:.6g}{} of translations", options.position_tolerance * metres, unit));
  if (std::isfinite(options.world_tolerance))
    parts.push_back(formatted("{:.6g}{} in the world", options.world_tolerance * metres, unit));
  return joined(parts, ", ");
}

}}  // namespace orispline
