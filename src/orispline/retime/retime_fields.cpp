// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime_fields.hpp>

#include <array>

#include <orispline/fields/field_codec.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

double duration_of(const Track& track) {
  return track.keys.size() == 0 ? 0.0 : track.keys.times().back() - track.keys.times().front();
}

}  // namespace

template <>
std::span<const FieldInfo> fields_of<RetimeOptions>() noexcept {
  static constexpr std::array fields{
      field<&RetimeOptions::limits, &MotionLimits::rate>({.name = "max_rate",
                                                          .sentence = "Largest angular velocity",
                                                          .quantity = &quantities::rate,
                                                          .range = positive}),
      field<&RetimeOptions::limits, &MotionLimits::acceleration>({.name = "max_acceleration",
                                                                  .sentence = "Largest angular acceleration",
                                                                  .quantity = &quantities::acceleration,
                                                                  .range = positive}),
      field<&RetimeOptions::limits, &MotionLimits::torque>(
          {.name = "max_torque",
           .sentence = "Largest torque, of a body with the given inertia",
           .quantity = &quantities::torque,
           .range = positive}),
      field<&RetimeOptions::limits, &MotionLimits::inertia>(
          {.name = "inertia", .sentence = "Inertia of the body, for the torque", .quantity = &quantities::inertia}),
      field<&RetimeOptions::slowing>({.name = "slowing", .sentence = "Which intervals between keys are slowed"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<Retiming>() noexcept {
  static constexpr std::array fields{
      field<&Retiming::slowing>(
          {.name = "slowing", .sentence = "How they were slowed; uniformly where that is the shorter motion"}),
      field<&Retiming::track, &Track::keys, &Keyframes::size>({.name = "keys", .sentence = "Number of keys"}),
      field<&Retiming::track, &duration_of>(
          {.name = "duration_after", .sentence = "From the first key to the last", .quantity = &quantities::time}),
      field<&Retiming::time_scale>({.name = "time_scale", .sentence = "That duration over the one before, at least 1"}),
      field<&Retiming::slack>(
          {.name = "slack",
           .sentence = "By which share less slowing might do, for the largest values found lie below the limits"}),
  };
  return fields;
}

}  // namespace orispline::inline ORISPLINE_ABI
