// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/retime.hpp>

#include <array>

#include <orispline/fields/field_codec.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
struct FieldCodec<Limit> {
  static constexpr FieldType type = FieldType::limit;
  static FieldValue value(const Limit& limit) { return Measured{limit.sizes, limit.stated_in}; }
  static bool assign(Limit& member, const FieldValue& value) {
    Measured measured;
    if (const double* number = std::get_if<double>(&value)) measured.numbers = {*number};
    else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) measured.numbers = *numbers;
    else if (const Measured* whole = std::get_if<Measured>(&value)) measured = *whole;
    if (measured.numbers.size() != 1 && measured.numbers.size() != 3) return false;
    member.sizes = std::move(measured.numbers);
    member.stated_in = measured.stated_in;
    return true;
  }
};

namespace {

/// A limit of RetimeOptions.
template <auto Member>
constexpr FieldInfo limit(std::string_view name, std::string_view sentence, const Quantity& quantity,
                          std::string_view example) {
  return field<&RetimeOptions::limits, Member>(
      {.name = name, .sentence = sentence, .quantity = &quantity, .range = positive, .example = example});
}

double duration_of(const Track& track) {
  return track.keys.size() == 0 ? 0.0 : track.keys.times().back() - track.keys.times().front();
}

/// A number of an even motion; absent for all others.
template <auto Member>
std::optional<double> of_evenness(const Retiming& retiming) {
  return retiming.evenness ? std::optional<double>((*retiming.evenness).*Member) : std::nullopt;
}
std::optional<double> unevenness_of(const Retiming& r) { return of_evenness<&Evenness::unevenness>(r); }
std::optional<double> turn_of(const Retiming& r) { return of_evenness<&Evenness::turn>(r); }
std::optional<double> shift_of(const Retiming& r) { return r.evenness ? r.evenness->shift : std::nullopt; }
std::optional<double> typed_longer_of(const Retiming& r) {
  return r.evenness ? r.evenness->typed_longer : std::nullopt;
}
std::optional<std::size_t> stops_of(const Retiming& r) {
  return r.evenness ? std::optional(r.evenness->stops) : std::nullopt;
}
std::optional<double> largest_rate_of(const Retiming& r) { return of_evenness<&Evenness::largest_rate>(r); }
std::optional<double> largest_acceleration_of(const Retiming& r) {
  return of_evenness<&Evenness::largest_acceleration>(r);
}

std::size_t number_of_inserted(const Retiming& retiming) { return retiming.inserted.size(); }
std::size_t number_of_rests(const Retiming& retiming) { return retiming.rests.size(); }

}  // namespace

template <>
std::span<const FieldInfo> fields_of<RetimeOptions>() noexcept {
  static constexpr std::array fields{
      limit<&MotionLimits::rate>("max_rate", "Largest angular velocity", quantities::rate,
                                 "90deg/s, or 90,60,120deg/s about x, y and z of the body"),
      limit<&MotionLimits::acceleration>("max_acceleration", "Largest angular acceleration", quantities::acceleration,
                                         "200deg/s2, or three about the axes"),
      limit<&MotionLimits::jerk>("max_jerk", "Largest angular jerk, the derivative of the angular acceleration",
                                 quantities::jerk, "2000deg/s3, or three"),
      limit<&MotionLimits::torque>("max_torque", "Largest torque on a body of the given inertia", quantities::torque,
                                   "0.5Nm, or three"),
      field<&RetimeOptions::limits, &MotionLimits::inertia>(
          {.name = "inertia", .sentence = "Inertia of the body, for the torque", .quantity = &quantities::inertia}),
      limit<&MotionLimits::speed>("max_speed", "Largest speed of the position", quantities::speed,
                                  "0.5m/s, or three along the axes of the world"),
      limit<&MotionLimits::linear_acceleration>("max_linear_acceleration", "Largest acceleration of the position",
                                                quantities::linear_acceleration, "2m/s2, or three"),
      field<&RetimeOptions::duration>(
          {.name = "duration",
           .sentence = "Scale the motion to exactly this duration, from the first key to the last",
           .quantity = &quantities::duration,
           .range = positive}),
      field<&RetimeOptions::slowing>({.name = "slowing", .sentence = "Which intervals between keys are slowed"}),
      field<&RetimeOptions::insert_keys>(
          {.name = "insert_keys",
           .sentence = "With the fastest keys: at most so many more keys in each interval, on the curve through yours, "
                       "where they make the motion faster",
           .range = {0.0, 100.0}}),
      field<&RetimeOptions::shorten_rests>({.name = "shorten_rests",
                                            .sentence = "Cut rests between equal keys that are longer to this duration",
                                            .quantity = &quantities::duration,
                                            .range = positive,
                                            .absent = "rests keep their duration"}),
      field<&RetimeOptions::constant_rate>(
          {.name = "constant_rate",
           .sentence = "Go along the same path by this angle each second, through more keys",
           .quantity = &quantities::rate,
           .range = positive,
           .example = "10deg/s"}),
      field<&RetimeOptions::constant_speed>(
          {.name = "constant_speed",
           .sentence = "Go along the same path by this distance of the positions each second, through more keys",
           .quantity = &quantities::speed,
           .range = positive,
           .example = "0.2m/s"}),
      field<&RetimeOptions::path_times>(
          {.name = "path_times", .sentence = "Which times of the keys shape the path of an even motion"}),
      field<&RetimeOptions::ease>(
          {.name = "ease",
           .sentence = "How long such an even motion takes to start and to stop, at the ends and where its path stops",
           .quantity = &quantities::duration,
           .range = positive,
           .example = "0.5s",
           .absent = "it is as fast at its ends"}),
  };
  return fields;
}

template <>
std::span<const FieldInfo> fields_of<Retiming>() noexcept {
  static constexpr std::array fields{
      field<&Retiming::slowing>(
          {.name = "slowing",
           .sentence = "How the intervals were slowed: uniformly too, where that makes the shorter motion"}),
      field<&Retiming::track, &Track::keys, &Keyframes::size>({.name = "keys", .sentence = "Number of keys"}),
      field<&number_of_inserted>({.name = "inserted", .sentence = "Number of them that were not given"}),
      field<&Retiming::track, &duration_of>({.name = "duration_after",
                                             .sentence = "Duration from the first key to the last",
                                             .quantity = &quantities::time}),
      field<&Retiming::time_scale>({.name = "time_scale", .sentence = "The new duration divided by the one before"}),
      field<&number_of_rests>({.name = "rests", .sentence = "Number of rests between equal keys"}),
      field<&Retiming::slack>(
          {.name = "slack",
           .sentence =
               "Share by which less slowing might be enough, since the largest values found lie below the limits"}),
      field<&unevenness_of>(
          {.name = "unevenness",
           .sentence = "Of an even motion the largest difference from the rate or speed asked for, as a share of it"}),
      field<&turn_of>({.name = "path_turn",
                       .sentence = "Of an even motion the largest angle between its orientation and that of the path",
                       .quantity = &quantities::angle}),
      field<&shift_of>({.name = "path_shift",
                        .sentence = "Of an even motion the largest distance between its position and that of the path",
                        .quantity = &quantities::length}),
      field<&typed_longer_of>({.name = "typed_longer",
                               .sentence =
                                   "Of an even motion by which share of its length the path is longer where the "
                                   "typed times shape it"}),
      field<&stops_of>(
          {.name = "stops", .sentence = "How often an even motion stops where its path turns back, besides its rests"}),
      field<&largest_rate_of>({.name = "largest_rate",
                               .sentence = "Of an even motion the largest angular velocity",
                               .quantity = &quantities::rate}),
      field<&largest_acceleration_of>({.name = "largest_acceleration",
                                       .sentence = "Of an even motion the largest angular acceleration",
                                       .quantity = &quantities::acceleration}),
  };
  return fields;
}

}}  // namespace orispline
