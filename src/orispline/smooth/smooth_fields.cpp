// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smooth_fields.hpp>

#include <algorithm>
#include <array>

#include <orispline/fields/field_codec.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

/// Nothing without a gyro.
std::optional<Eigen::Vector3d> gyro_correction(const Smoothing& smoothing) {
  return smoothing.gyro_noise ? std::optional(smoothing.nodes.gyro_correction) : std::nullopt;
}

/// Of the positions; nothing without any.
template <auto Member>
std::optional<std::remove_cvref_t<decltype(PositionSmoothing{}.*Member)>> of_positions(const Smoothing& smoothing) {
  return smoothing.positions ? std::optional((*smoothing.positions).*Member) : std::nullopt;
}
template <auto Member>
std::remove_cvref_t<decltype(PositionSmoothing{}.*Member)> optional_of_positions(const Smoothing& smoothing) {
  return smoothing.positions ? (*smoothing.positions).*Member : std::nullopt;
}
std::optional<double> position_cutoff(const Smoothing& smoothing) {
  return smoothing.positions ? smoothing.positions->cutoff() : std::nullopt;
}
template <auto Distances, auto Member>
std::optional<double> position_distance(const Smoothing& smoothing) {
  return smoothing.positions ? std::optional((*smoothing.positions).*Distances.*Member) : std::nullopt;
}

double rms_distance(const Smoothing& smoothing) { return smoothing.distances.rms; }
double largest_distance(const Smoothing& smoothing) { return smoothing.distances.largest; }
double accepted_rms_distance(const Smoothing& smoothing) { return smoothing.accepted_distances.rms; }
double accepted_largest_distance(const Smoothing& smoothing) { return smoothing.accepted_distances.largest; }

}  // namespace

template <>
struct FieldCodec<std::vector<Stretch>> {
  static constexpr FieldType type = FieldType::runs;
  static FieldValue value(const std::vector<Stretch>& stretches) {
    std::vector<SampleRun> runs;
    for (const auto& [first, count] : stretches) runs.emplace_back(first, count);
    return runs;
  }
};

template <>
std::span<const FieldInfo> fields_of<SmoothOptions>() noexcept {
  static constexpr std::array fields{
      field<&SmoothOptions::penalty>({.name = "penalty", .sentence = "What is kept small, squared and integrated"}),
      field<&SmoothOptions::noise>({.name = "noise",
                                    .sentence = "Standard deviation of the orientations per axis",
                                    .quantity = &quantities::angle,
                                    .range = {least_noise, largest_noise}}),
      field<&SmoothOptions::smoothing_time>({.name = "smoothing_time",
                                             .sentence = "Smoothing time tau",
                                             .quantity = &quantities::time,
                                             .range = positive,
                                             .absent = "chosen"}),
      field<&SmoothOptions::loss>(
          {.name = "loss",
           .sentence = "How much badly fitting samples count: robust rejects outliers, l2 trusts every sample"}),
      field<&SmoothOptions::gyro>(
          {.name = "gyro",
           .sentence =
               "The angular velocities wx, wy, wz are those of a gyro, with a constant bias that is estimated"}),
      field<&SmoothOptions::gyro_noise>({.name = "gyro_noise",
                                         .sentence = "Standard deviation of the gyro's rates per axis",
                                         .quantity = &quantities::rate,
                                         .range = {1e-9, 1e3},
                                         .example = "0.1deg/s",
                                         .absent = "estimated"}),
      field<&SmoothOptions::position_noise>({.name = "position_noise",
                                             .sentence = "Standard deviation of the positions per axis",
                                             .quantity = &quantities::length,
                                             .range = {1e-12, 1e12},
                                             .example = "2cm",
                                             .absent = "estimated"}),
      field<&SmoothOptions::gap>({.name = "gap",
                                  .sentence = "Nothing is smoothed over longer intervals",
                                  .quantity = &quantities::time,
                                  .range = positive,
                                  .absent = "bridged"}),
  };
  return fields;
}

namespace {

constexpr std::array of_orientations{
    field<&Smoothing::smoothing_time>(
        {.name = "smoothing_time", .sentence = "Smoothing time τ", .quantity = &quantities::time}),
    field<&Smoothing::cutoff>(
        {.name = "cutoff", .sentence = "The frequency 1/(2πτ)", .quantity = &quantities::frequency}),
    field<&Smoothing::lambda>({.name = "lambda", .sentence = "Weight λ of the penalty"}),
    field<&Smoothing::criterion>({.name = "criterion", .sentence = "By what τ was chosen", .absent = "τ was stated"}),
    field<&Smoothing::chosen_on>({.name = "chosen_on", .sentence = "Number of samples that the choice of τ saw"}),
    field<&Smoothing::noise>({.name = "noise",
                              .sentence = "σ of the orientations per axis, from the residuals or as stated",
                              .quantity = &quantities::angle}),
    field<&Smoothing::local_noise>({.name = "local_noise",
                                    .sentence = "σ per axis, from how far samples are from their neighbours",
                                    .quantity = &quantities::angle}),
    field<&Smoothing::degrees_of_freedom>(
        {.name = "degrees_of_freedom",
         .sentence = "Effective degrees of freedom of the curve, of three for each key",
         .absent = "with a gyro"}),
    field<&Smoothing::gyro_noise>({.name = "gyro_noise",
                                   .sentence = "σ of the gyro per axis",
                                   .quantity = &quantities::rate,
                                   .absent = "without a gyro"}),
    field<&gyro_correction>({.name = "gyro_correction",
                             .sentence = "What is added to the rates of the gyro",
                             .quantity = &quantities::rate,
                             .absent = "without a gyro"}),
    field<&rms_distance>({.name = "rms_distance",
                          .sentence = "Root mean square of the angles to the samples",
                          .quantity = &quantities::angle}),
    field<&largest_distance>(
        {.name = "largest_distance", .sentence = "The largest angle to a sample", .quantity = &quantities::angle}),
    field<&accepted_rms_distance>({.name = "accepted_rms_distance",
                                   .sentence = "Root mean square of the angles to the samples that are not rejected",
                                   .quantity = &quantities::angle}),
    field<&accepted_largest_distance>({.name = "accepted_largest_distance",
                                       .sentence = "The largest angle to a sample that is not rejected",
                                       .quantity = &quantities::angle}),
    field<&Smoothing::rejected>({.name = "rejected", .sentence = "The samples that do not count"}),
    field<&Smoothing::rejected_gyro>({.name = "rejected_gyro", .sentence = "The samples whose rates do not count"}),
    field<&Smoothing::retained_outlier_runs>(
        {.name = "retained_outlier_runs",
         .sentence = "Samples as far away that stay, for their neighbours are far away too"}),
    field<&Smoothing::samples_in_short_stretches>(
        {.name = "samples_in_short_stretches", .sentence = "Samples between gaps that are too few"}),
    field<&Smoothing::stretches>({.name = "stretches", .sentence = "What lies between gaps"}),
    field<&Smoothing::iterations>({.name = "iterations", .sentence = "Iterations of the last fit"}),
    field<&Smoothing::last_step>({.name = "last_step",
                                  .sentence = "The largest component by which an orientation moved in the last of them",
                                  .quantity = &quantities::angle}),
};

constexpr std::array of_their_positions{
    field<&optional_of_positions<&PositionSmoothing::smoothing_time>>(
        {.name = "position_smoothing_time",
         .sentence = "Smoothing time τ of the positions",
         .quantity = &quantities::time,
         .absent = "no positions, or none with noise: they are as they were"}),
    field<&position_cutoff>({.name = "position_cutoff",
                             .sentence = "The frequency 1/(2πτ) of the positions",
                             .quantity = &quantities::frequency,
                             .absent = "likewise"}),
    field<&optional_of_positions<&PositionSmoothing::criterion>>(
        {.name = "position_criterion",
         .sentence = "By what τ of the positions was chosen",
         .absent = "τ was stated, or there was nothing to choose by"}),
    field<&of_positions<&PositionSmoothing::noise>>({.name = "position_noise",
                                                     .sentence = "σ of the positions per axis, from the residuals",
                                                     .quantity = &quantities::length,
                                                     .absent = "no positions"}),
    field<&of_positions<&PositionSmoothing::local_noise>>(
        {.name = "position_local_noise",
         .sentence = "σ per axis, from how far positions are from their neighbours",
         .quantity = &quantities::length,
         .absent = "no positions"}),
    field<&position_distance<&PositionSmoothing::distances, &SampleDistances::rms>>(
        {.name = "position_rms_distance",
         .sentence = "Root mean square of the distances to the samples",
         .quantity = &quantities::length,
         .absent = "no positions"}),
    field<&position_distance<&PositionSmoothing::distances, &SampleDistances::largest>>(
        {.name = "position_largest_distance",
         .sentence = "The largest distance to a sample",
         .quantity = &quantities::length,
         .absent = "no positions"}),
    field<&position_distance<&PositionSmoothing::accepted_distances, &SampleDistances::rms>>(
        {.name = "position_accepted_rms",
         .sentence = "Root mean square of the distances to the samples whose positions are not rejected",
         .quantity = &quantities::length,
         .absent = "no positions"}),
    field<&position_distance<&PositionSmoothing::accepted_distances, &SampleDistances::largest>>(
        {.name = "position_accepted_largest",
         .sentence = "The largest distance to a sample whose position is not rejected",
         .quantity = &quantities::length,
         .absent = "no positions"}),
    field<&of_positions<&PositionSmoothing::rejected>>({.name = "rejected_positions",
                                                        .sentence = "The samples whose positions do not count",
                                                        .absent = "no positions"}),
    field<&of_positions<&PositionSmoothing::retained_outlier_runs>>(
        {.name = "retained_position_runs",
         .sentence = "Samples whose positions are as far away and stay, for their neighbours are far away too",
         .absent = "no positions"}),
};

constexpr auto smoothing_results = [] {
  std::array<FieldInfo, of_orientations.size() + of_their_positions.size()> all{};
  std::ranges::copy(of_their_positions, std::ranges::copy(of_orientations, all.begin()).out);
  return all;
}();

}  // namespace

template <>
std::span<const FieldInfo> fields_of<Smoothing>() noexcept {
  return smoothing_results;
}

}  // namespace orispline::inline ORISPLINE_ABI
