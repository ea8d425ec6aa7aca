// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/fields/field.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Nothing where the recording has no positions.
std::optional<std::size_t> position_sample(const Deviation& deviation) {
  return deviation.position ? std::optional(deviation.position_at) : std::nullopt;
}

constexpr Interval positive_or_none{positive.lowest, std::numeric_limits<double>::infinity()};

}  // namespace

template <>
std::span<const FieldInfo> fields_of<ReduceOptions>() noexcept {
  static constexpr std::array fields{
      field<&ReduceOptions::tolerance, &Tolerance::angle>(
          {.name = "tolerance",
           .sentence = "Largest angle that is allowed between the curve and a sample",
           .quantity = &quantities::angle,
           .range = positive,
           .example = "0.1deg or 2e-3rad",
           .is_required = true}),
      field<&ReduceOptions::tolerance, &Tolerance::position>(
          {.name = "position_tolerance",
           .sentence = "Largest distance that is allowed between the path and a sample",
           .quantity = &quantities::length,
           .range = {positive.lowest, std::numeric_limits<double>::infinity()},
           .absent = "positions are not checked"}),
      field<&ReduceOptions::values>({.name = "values", .sentence = "Whether keys stay at samples"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<Reduction>() noexcept {
  static constexpr std::array fields{
      field<&Reduction::track, &Track::keys, &Keyframes::size>({.name = "keys", .sentence = "Number of keys"}),
      field<&Reduction::deviation, &Deviation::angle>(
          {.name = "error_max",
           .sentence = "Largest angle between the curve and a sample, over all samples",
           .quantity = &quantities::angle_in_degrees}),
      field<&Reduction::deviation, &Deviation::angle_at>({.name = "error_max_time",
                                                          .sentence = "Time of the sample with the largest angle",
                                                          .quantity = &quantities::time,
                                                          .type = FieldType::sample}),
      field<&Reduction::deviation, &Deviation::position>({.name = "position_error_max",
                                                          .sentence = "Largest distance between the path and a sample",
                                                          .quantity = &quantities::length,
                                                          .absent = "the recording has no positions"}),
      field<&Reduction::deviation, &position_sample>({.name = "position_error_max_time",
                                                      .sentence = "Time of the sample with the largest distance",
                                                      .quantity = &quantities::time,
                                                      .absent = "the recording has no positions",
                                                      .type = FieldType::sample}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<ClipReduceOptions>() noexcept {
  static constexpr std::array fields{
      field<&ClipReduceOptions::tolerance>(
          {.name = "tolerance",
           .sentence = "Largest angle that a joint may be off at any time, in the frame of its parent",
           .quantity = &quantities::angle,
           .range = positive_or_none,
           .example = "0.1deg or 2e-3rad",
           .absent = "angles are not bounded"}),
      field<&ClipReduceOptions::position_tolerance>(
          {.name = "position_tolerance",
           .sentence = "Largest distance that a joint's translation may be off at any time",
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
          {.name = "between",
           .sentence = "What the motion of a clip between its keys is taken to be; of BVH, whose frames are samples, "
                       "smooth unless you say otherwise"}),
      field<&ClipReduceOptions::compression>(
          {.name = "compress", .sentence = "How the keys are compressed in the file, where it is glTF"}),
      field<&ClipReduceOptions::next_tool>(
          {.name = "for", .sentence = "What the file goes through next, whose faults are kept clear of"}),
      field<&ClipReduceOptions::cuts>(
          {.name = "cuts", .sentence = "Which jumps of joints are cuts, on either side of which nothing swings"}),
      field<&ClipReduceOptions::keep_constant>(
          {.name = "keep_constant",
           .sentence = "Keep tracks of one key that says what the rest pose of the joint says, which are left out "
                       "otherwise"}),
  };
  return fields;
}

std::string tolerance_text(const ClipReduceOptions& options, std::string_view unit) {
  std::vector<std::string> parts;
  if (std::isfinite(options.tolerance)) parts.push_back(formatted("{:.6g}°", options.tolerance * degrees));
  if (std::isfinite(options.position_tolerance))
    parts.push_back(formatted("{:.6g}{} of translations", options.position_tolerance, unit));
  if (std::isfinite(options.world_tolerance))
    parts.push_back(formatted("{:.6g}{} in the world", options.world_tolerance, unit));
  return joined(parts, ", ");
}

}}  // namespace orispline
