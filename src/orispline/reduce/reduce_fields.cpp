// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/reduce_fields.hpp>

#include <array>

#include <orispline/fields/field.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Nothing where the recording has no positions.
std::optional<std::size_t> position_sample(const Deviation& deviation) {
  return deviation.position ? std::optional(deviation.position_at) : std::nullopt;
}

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

}}  // namespace orispline
