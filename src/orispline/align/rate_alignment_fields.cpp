// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/rate_alignment.hpp>

#include <array>

#include <orispline/fields/field_codec.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

double late_by(const RateAlignment& alignment) { return alignment.offset.to_double(); }
template <auto Which, auto Member>
std::optional<double> statistic(const RateAlignment& alignment) {
  return alignment.*Which ? std::optional((*(alignment.*Which)).*Member) : std::nullopt;
}

constexpr FieldInfo of_rates(std::string_view name, std::string_view sentence, const Quantity* quantity = nullptr,
                             std::string_view absent = {}) {
  FieldInfo info{.name = name, .sentence = sentence, .quantity = quantity};
  info.absent = absent;
  return info;
}

}  // namespace

template <>
std::span<const FieldInfo> fields_of<RateAlignment>() noexcept {
  constexpr auto time = &quantities::time, angle = &quantities::angle, shown_angle = &quantities::angle_in_degrees,
                 rate = &quantities::rate;
  constexpr std::string_view two_gyros = "both recordings are of gyros", poses = "one recording is of orientations";
  constexpr auto angles = &RateAlignment::distance, rates = &RateAlignment::rate_distance;
  static constexpr std::array fields{
      field<&late_by>(of_rates("offset", "By how much the stamps of the moved recording are late", time)),
      field<&RateAlignment::offset_sigma>(of_rates("offset_sigma", "One standard deviation of the offset", time)),
      field<&RateAlignment::body_sigma>(
          of_rates("body_sigma", "One standard deviation of turns of the body about its axes x, y, z", angle)),
      field<&RateAlignment::bias>(
          of_rates("bias", "What the gyro reads too much along its axes, beside a second gyro the difference", rate)),
      field<&RateAlignment::bias_sigma>(of_rates("bias_sigma", "One standard deviation of the bias", rate)),
      field<&RateAlignment::compared>(of_rates("compared", "Number of turns that were compared")),
      field<&RateAlignment::rejected_moved>(
          of_rates("rejected_moved", "Samples of the moved recording that do not count")),
      field<&RateAlignment::rejected_fixed>(
          of_rates("rejected_fixed", "Samples of the fixed recording that do not count")),
      field<&statistic<angles, &DistanceStatistics::rms>>(of_rates(
          "distance_rms", "Root mean square distance of orientations from where the gyro leads from those before",
          shown_angle, two_gyros)),
      field<&statistic<angles, &DistanceStatistics::median>>(
          of_rates("distance_median", "Half of these distances are not greater", shown_angle, two_gyros)),
      field<&statistic<angles, &DistanceStatistics::largest>>(
          of_rates("distance_max", "Largest of these distances", shown_angle, two_gyros)),
      field<&statistic<rates, &DistanceStatistics::rms>>(
          of_rates("rate_rms", "Root mean square difference between the mean rates over about 50 ms", rate, poses)),
      field<&statistic<rates, &DistanceStatistics::median>>(
          of_rates("rate_median", "Half of these differences are not greater", rate, poses)),
      field<&statistic<rates, &DistanceStatistics::largest>>(
          of_rates("rate_max", "Largest of these differences", rate, poses)),
      field<&RateAlignment::excess>(of_rates("excess", "What is left, robust, over what the noise of both explains")),
  };
  return fields;
}

}}  // namespace orispline
