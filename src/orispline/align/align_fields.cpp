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
std::optional<double> position_distance(const Alignment& alignment) {
  return alignment.position_distance ? std::optional((*alignment.position_distance).*Member) : std::nullopt;
}

constexpr FieldInfo result(std::string_view name, std::string_view sentence, const Quantity* quantity = nullptr) {
  return {.name = name, .sentence = sentence, .quantity = quantity};
}

constexpr FieldInfo of_positions(std::string_view name, std::string_view sentence, const Quantity* quantity = nullptr) {
  FieldInfo info = result(name, sentence, quantity);
  info.absent = "one of the recordings has no positions";
  return info;
}

}  // namespace

template <>
std::span<const FieldInfo> fields_of<AlignOptions>() noexcept {
  static constexpr std::array fields{
      field<&AlignOptions::world_turn>({.name = "world_turn",
                                        .sentence = "Look for the rotation between the axes of the two worlds",
                                        .without = "Take the axes of the two worlds to be the same"}),
      field<&AlignOptions::body_turn>({.name = "body_turn",
                                       .sentence = "Look for the rotation between the axes of the two bodies",
                                       .without = "Take the axes of the two bodies to be the same"}),
      field<&AlignOptions::offset>(
          {.name = "offset",
           .sentence = "By how much the stamps of the moved recording are late, negative where they are early",
           .quantity = &quantities::time,
           .example = "0.1, or 0 for clocks that agree",
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
  constexpr auto time = &quantities::time, angle = &quantities::angle, shown_angle = &quantities::angle_in_degrees,
                 length = &quantities::length;
  static constexpr std::array fields{
      field<&offset_of>(result("offset", "By how much the stamps of the moved recording are late", time)),
      field<&offset_sigma>(result("offset_sigma", "One standard deviation of the offset", time)),
      field<&world_sigma>(
          result("world_sigma", "One standard deviation of turns of the world about its axes x, y, z", angle)),
      field<&body_sigma>(
          result("body_sigma", "One standard deviation of turns of the body about its axes x, y, z", angle)),
      field<&Alignment::scale>(of_positions("scale", "What positions are multiplied by")),
      field<&scale_sigma>(of_positions("scale_sigma", "One standard deviation of the scale")),
      field<&Alignment::translation>(
          of_positions("translation", "What is added to positions that are turned and scaled", length)),
      field<&translation_sigma>(of_positions(
          "translation_sigma", "One standard deviation of the translation along the axes of the world", length)),
      field<&number_compared>(
          result("compared", "Number of samples of the fixed recording beside which the moved one has a motion")),
      field<&Alignment::rejected>(result("rejected", "Those of them that are too far away to count")),
      field<&rms_distance>(
          result("distance_rms", "Root mean square distance of the orientations, rejected ones too", shown_angle)),
      field<&median_distance>(result("distance_median", "Half of the distances are not greater", shown_angle)),
      field<&largest_distance>(result("distance_max", "Largest distance of the orientations", shown_angle)),
      field<&Alignment::noise>(
          result("noise", "Robust standard deviation of what is left between the orientations, per axis", shown_angle)),
      field<&position_distance<&DistanceStatistics::rms>>(
          of_positions("position_rms", "Root mean square distance of the positions, rejected ones too", length)),
      field<&position_distance<&DistanceStatistics::median>>(
          of_positions("position_median", "Half of their distances are not greater", length)),
      field<&position_distance<&DistanceStatistics::largest>>(
          of_positions("position_max", "Largest distance of the positions", length)),
      field<&Alignment::position_noise>(of_positions(
          "position_noise", "Robust standard deviation of what is left between the positions, per axis", length)),
  };
  return fields;
}

}}  // namespace orispline
