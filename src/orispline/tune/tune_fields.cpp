// SPDX-License-Identifier: Apache-2.0
#include <orispline/tune/tune.hpp>

#include <array>

#include <orispline/fields/field_codec.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
struct FieldCodec<Interval> {
  static constexpr FieldType type = FieldType::interval;
  static FieldValue value(const Interval& interval) { return std::vector{interval.lowest, interval.highest}; }
  static bool assign(Interval& member, const FieldValue& value) {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (!numbers || numbers->size() != 2) return false;
    member = {numbers->front(), numbers->back()};
    return true;
  }
};

template <>
struct FieldCodec<OrientationSeries> {
  static constexpr FieldType type = FieldType::recording;
  static FieldValue value(const OrientationSeries&) { return {}; }
  static bool assign(OrientationSeries&, const FieldValue&) { return false; }
};

std::string_view unit_of(Objective objective) noexcept {
  switch (objective) {
    case Objective::torque:
      return "N^2 m^2 s";
    case Objective::jerk:
      return "rad^2/s^5";
    case Objective::curvature:
      return "1/rad";
    case Objective::fit:
      return "rad^2";
    default:
      return "rad^2/s^3";
  }
}

template <>
std::span<const FieldInfo> fields_of<TuneOptions>() noexcept {
  static constexpr std::array fields{
      field<&TuneOptions::objective>({.name = "objective", .sentence = "Integral that the tensions make least"}),
      field<&TuneOptions::inertia>({.name = "inertia",
                                    .sentence = "Inertia of the body that turns, for the objective torque",
                                    .quantity = &quantities::inertia}),
      field<&TuneOptions::reference>(
          {.name = "reference", .sentence = "Dense recording that the curve comes near to, for the objective fit"}),
      field<&TuneOptions::bounds>({.name = "bounds",
                                   .sentence = "Lowest and highest value of every tension",
                                   .absent = "what the method accepts"}),
      field<&TuneOptions::parameters>(
          {.name = "free", .sentence = "Tensions to find, such as tension2", .absent = "all tensions of the method"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<Tuning>() noexcept {
  static constexpr std::array fields{
      field<&Tuning::energy_before>(
          {.name = "energy_before", .sentence = "Energy before tuning, in the unit of the objective"}),
      field<&Tuning::energy_after>({.name = "energy_after", .sentence = "Energy with the tensions that were found"}),
      field<&Tuning::iterations>(
          {.name = "iterations", .sentence = "Iterations of the refinement; 0 for the closed form"}),
      field<&Tuning::stationarity>(
          {.name = "stationarity", .sentence = "Share of the energy by which another step would lower it"}),
  };
  return fields;
}

}}  // namespace orispline
