// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/align.hpp>

#include <array>

#include <orispline/fields/field_codec.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double offset_of(const Alignment& alignment) { return alignment.offset.to_double(); }
double offset_sigma(const Alignment& alignment) { return alignment.sigmas.offset; }
Eigen::Vector3d world_sigma(const Alignment& alignment) { return alignment.sigmas.world; }
Eigen::Vector3d body_sigma(const Alignment& alignment) { return alignment.sigmas.body; }
std::optional<double> scale_sigma(const Alignment& alignment) {
  return alignment.scale ? std::optional(alignment.sigmas.scale) : std::nullopt;
}
std::optional<Eigen::Vector3d> translation_sigma(const Alignment& alignment) {
  return alignment.translation ? std::optional(alignment.sigmas.translation) : std::nullopt;
}
std::size_t number_compared(const Alignment& alignment) { return alignment.compared.size(); }
double rms_distance(const Alignment& alignment) { return alignment.distance.rms; }
double median_distance(const Alignment& alignment) { return alignment.distance.median; }
double largest_distance(const Alignment& alignment) { return alignment.distance.largest; }
template <auto Member>
std::optional<double> of_positions(const Alignment& alignment) {
  return alignment.position_distance ? std::optional((*alignment.position_distance).*Member) : std::nullopt;
}

}  // namespace

template <>
std::span<const FieldInfo> fields_of<AlignOptions>() noexcept {
  static constexpr std::array fields{
      field<&AlignOptions::world_rotation>({.name = "world_rotation",
                                            .sentence = "Look for the rotation between the axes of the two worlds",
                                            .without = "Take the axes of the two worlds to be the same"}),
      field<&AlignOptions::body_rotation>({.name = "body_rotation",
                                           .sentence = "Look for the rotation between the axes of the two bodies",
                                           .without = "Take the axes of the two bodies to be the same"}),
      field<&AlignOptions::offset>({.name = "offset",
                                    .sentence = "How late the stamps of the moved recording are; negative: early",
                                    .quantity = &quantities::duration,
                                    .example = "0.1s, or 0 for clocks that agree",
                                    .absent = "looked for"}),
      field<&AlignOptions::scale>({.name = "scale",
                                   .sentence = "Look for the scale of the positions",
                                   .without = "Take the positions of both to be in one unit"}),
      field<&AlignOptions::translation>({.name = "translation",
                                         .sentence = "Look for the translation between the origins of the two worlds",
                                         .without = "Take the origins of the two worlds to be the same"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<Alignment>() noexcept {
  static constexpr std::array fields{
      field<&offset_of>({.name = "offset",
                         .sentence = "How late the stamps of the moved recording are",
                         .quantity = &quantities::time}),
      field<&offset_sigma>(
          {.name = "offset_sigma", .sentence = "One standard deviation of the offset", .quantity = &quantities::time}),
      field<&world_sigma>({.name = "world_sigma",
                           .sentence = "One standard deviation of turns of the world about its axes x, y, z",
                           .quantity = &quantities::angle}),
      field<&body_sigma>({.name = "body_sigma",
                          .sentence = "One standard deviation of turns of the body about its axes x, y, z",
                          .quantity = &quantities::angle}),
      field<&Alignment::scale>({.name = "scale",
                                .sentence = "What positions are multiplied by",
                                .absent = "one of the recordings has no positions"}),
      field<&scale_sigma>({.name = "scale_sigma",
                           .sentence = "One standard deviation of the scale",
                           .absent = "one of the recordings has no positions"}),
      field<&Alignment::translation>({.name = "translation",
                                      .sentence = "What is added to positions that are turned and scaled",
                                      .quantity = &quantities::length,
                                      .absent = "one of the recordings has no positions"}),
      field<&translation_sigma>({.name = "translation_sigma",
                                 .sentence = "One standard deviation of the translation along the axes of the world",
                                 .quantity = &quantities::length,
                                 .absent = "one of the recordings has no positions"}),
      field<&number_compared>({.name = "compared", .sentence = "Number of samples of the fixed recording that count"}),
      field<&Alignment::rejected>(
          {.name = "rejected", .sentence = "Samples of the fixed recording that are too far away to count"}),
      field<&rms_distance>({.name = "distance_rms",
                            .sentence = "Root mean square distance of the orientations, rejected ones too",
                            .quantity = &quantities::angle_in_degrees}),
      field<&median_distance>({.name = "distance_median",
                               .sentence = "Half of the distances are not greater",
                               .quantity = &quantities::angle_in_degrees}),
      field<&largest_distance>({.name = "distance_max",
                                .sentence = "Largest distance of the orientations",
                                .quantity = &quantities::angle_in_degrees}),
      field<&Alignment::noise>(
          {.name = "noise",
           .sentence = "Robust standard deviation of what is left between the orientations, per axis",
           .quantity = &quantities::angle_in_degrees}),
      field<&of_positions<&DistanceStatistics::rms>>(
          {.name = "position_rms",
           .sentence = "Root mean square distance of the positions, rejected ones too",
           .quantity = &quantities::length,
           .absent = "one of the recordings has no positions"}),
      field<&of_positions<&DistanceStatistics::median>>({.name = "position_median",
                                                         .sentence = "Half of their distances are not greater",
                                                         .quantity = &quantities::length,
                                                         .absent = "one of the recordings has no positions"}),
      field<&of_positions<&DistanceStatistics::largest>>({.name = "position_max",
                                                          .sentence = "Largest distance of the positions",
                                                          .quantity = &quantities::length,
                                                          .absent = "one of the recordings has no positions"}),
      field<&Alignment::position_noise>(
          {.name = "position_noise",
           .sentence = "Robust standard deviation of what is left between the positions, per axis",
           .quantity = &quantities::length,
           .absent = "one of the recordings has no positions"}),
  };
  return fields;
}

}}  // namespace orispline
