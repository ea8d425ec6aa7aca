// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smooth.hpp>

#include <algorithm>
#include <array>

#include <orispline/fields/field_codec.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Of the gyro; nothing without one.
template <auto Member>
std::optional<std::remove_cvref_t<decltype(GyroFinding{}.*Member)>> of_gyro(const Smoothing& smoothing) {
  return smoothing.gyro ? std::optional((*smoothing.gyro).*Member) : std::nullopt;
}
template <auto Member>
std::remove_cvref_t<decltype(GyroFinding{}.*Member)> optional_of_gyro(const Smoothing& smoothing) {
  return smoothing.gyro ? (*smoothing.gyro).*Member : std::nullopt;
}
std::optional<Eigen::Vector3d> gyro_correction(const Smoothing& smoothing) {
  return smoothing.gyro && smoothing.gyro->used ? std::optional(smoothing.nodes.gyro_correction) : std::nullopt;
}
std::vector<std::size_t> rejected_gyro(const Smoothing& smoothing) {
  return smoothing.gyro ? smoothing.gyro->rejected : std::vector<std::size_t>();
}
template <auto Member>
std::optional<double> risk(const Smoothing& smoothing) {
  return smoothing.gyro && smoothing.gyro->risk ? std::optional((*smoothing.gyro->risk).*Member) : std::nullopt;
}

/// The value, or its σ, of what was found of a gyro that counts.
template <auto Member, int Which>
auto found_of_gyro(const Smoothing& smoothing) {
  using Value = decltype((*(GyroFinding{}.*Member)).value);
  const auto* const found =
      smoothing.gyro && smoothing.gyro->used && (*smoothing.gyro).*Member ? &*((*smoothing.gyro).*Member) : nullptr;
  if (!found) return std::optional<Value>();
  return std::optional<Value>(Which == 0 ? found->value : found->sigma);
}
template <auto Member>
std::optional<double> correlated(const Smoothing& smoothing) {
  return smoothing.correlated_noise ? std::optional((*smoothing.correlated_noise).*Member) : std::nullopt;
}
template <auto Member>
std::optional<double> hidden(const Smoothing& smoothing) {
  return smoothing.hidden_noise ? std::optional((*smoothing.hidden_noise).*Member) : std::nullopt;
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
    runs.reserve(stretches.size());
    for (const auto& [first, count] : stretches) runs.emplace_back(first, count);
    return runs;
  }
};

namespace {

constexpr std::array of_options{
    field<&SmoothOptions::penalty>({.name = "penalty",
                                    .sentence = "Rate whose squared integral is kept small",
                                    .absent = "acceleration, or jerk with a gyro that does not count turns"}),
    field<&SmoothOptions::noise>({.name = "noise",
                                  .sentence = "Standard deviation of the noise of the orientations, per axis",
                                  .quantity = &quantities::angle,
                                  .range = {least_noise, largest_noise}}),
    field<&SmoothOptions::noise_time>(
        {.name = "noise_time",
         .sentence = "The time within which the correlation of the noise of the orientations falls to 1/e",
         .quantity = &quantities::duration,
         .range = positive,
         .example = "50ms",
         .absent = "the noise is taken for white, or found with a gyro"}),
    field<&SmoothOptions::smoothing_time>({.name = "smoothing_time",
                                           .sentence = "Smoothing time tau; a longer one smooths more",
                                           .quantity = &quantities::time,
                                           .range = positive,
                                           .absent = "chosen from the recording"}),
    field<&SmoothOptions::loss>(
        {.name = "loss",
         .sentence = "How much samples far from the curve count: robust rejects outliers, l2 trusts every sample"}),
    field<&SmoothOptions::gyro>(
        {.name = "gyro", .sentence = "Use wx, wy, wz as the rates of a gyro, whose bias is estimated"}),
    field<&SmoothOptions::gyro_noise>({.name = "gyro_noise",
                                       .sentence = "Standard deviation of the noise of the gyro's rates, per axis",
                                       .quantity = &quantities::rate,
                                       .range = {1e-9, 1e3},
                                       .example = "0.1deg/s",
                                       .absent = "estimated"}),
    field<&SmoothOptions::gyro_offset>({.name = "gyro_offset",
                                        .sentence = "By how much the stamps of the gyro are late",
                                        .quantity = &quantities::time,
                                        .example = "0.02",
                                        .absent = "auto: found from the recording"}),
    field<&SmoothOptions::gyro_bias>(
        {.name = "gyro_bias",
         .sentence = "The bias of the gyro",
         .absent = "auto: constant, unless a walk or a trend explains the recording better"}),
    field<&SmoothOptions::position_noise>({.name = "position_noise",
                                           .sentence = "Standard deviation of the noise of the positions, per axis",
                                           .quantity = &quantities::length,
                                           .range = {1e-12, 1e12},
                                           .example = "2cm",
                                           .absent = "estimated"}),
    field<&SmoothOptions::gap>({.name = "gap",
                                .sentence = "Smooth nothing across intervals longer than this",
                                .quantity = &quantities::time,
                                .range = positive,
                                .absent = "all are bridged"}),
    field<&SmoothOptions::adapt>({.name = "adapt",
                                  .sentence = "Let the smoothing time of the orientations vary in time, where that "
                                              "predicts the samples clearly better",
                                  .without = "Keep one smoothing time for the whole recording, even where one that "
                                             "varies in time predicts the samples clearly better"}),
    field<&SmoothOptions::runs>({.name = "runs",
                                 .sentence = "Of a skeleton: bridge runs of frames in which joints jump away and "
                                             "back while the others go on",
                                 .without = "Of a skeleton: keep runs of frames in which joints jump away and back "
                                            "while the others go on"}),
    field<&SmoothOptions::keep_contacts>(
        {.name = "keep_contacts",
         .sentence = "Of a skeleton: joints that stay where they stand on the ground, or auto for those in which its "
                     "legs end",
         .absent = "none is held"}),
    field<&SmoothOptions::sigma>(
        {.name = "sigma",
         .sentence = "Add one standard deviation of every orientation and rate, along the axes of the body"}),
};

constexpr std::array of_orientations{
    field<&Smoothing::smoothing_time>(
        {.name = "smoothing_time", .sentence = "Smoothing time τ", .quantity = &quantities::time}),
    field<&Smoothing::shortest_smoothing_time>({.name = "shortest_smoothing_time",
                                                .sentence = "The shortest τ, where it varies in time",
                                                .quantity = &quantities::time,
                                                .absent = "τ is the same everywhere"}),
    field<&Smoothing::longest_smoothing_time>({.name = "longest_smoothing_time",
                                               .sentence = "The longest τ, where it varies in time",
                                               .quantity = &quantities::time,
                                               .absent = "τ is the same everywhere"}),
    field<&Smoothing::cutoff>(
        {.name = "cutoff", .sentence = "Cut-off frequency 1/(2πτ)", .quantity = &quantities::frequency}),
    field<&Smoothing::lambda>({.name = "lambda", .sentence = "Weight λ of the penalty"}),
    field<&Smoothing::criterion>({.name = "criterion", .sentence = "How τ was chosen", .absent = "τ was given"}),
    field<&Smoothing::chosen_on>({.name = "chosen_on", .sentence = "Number of samples from which τ was chosen"}),
    field<&Smoothing::noise>({.name = "noise",
                              .sentence = "σ of the noise of the orientations per axis, from the residuals or as given",
                              .quantity = &quantities::angle}),
    field<&Smoothing::local_noise>({.name = "local_noise",
                                    .sentence = "σ of the noise per axis, from the differences between neighbours",
                                    .quantity = &quantities::angle}),
    field<&Smoothing::least_noise_of_samples>({.name = "least_noise",
                                               .sentence = "The least σ by which samples are weighed, stated or found",
                                               .quantity = &quantities::angle,
                                               .absent = "all samples count the same"}),
    field<&Smoothing::largest_noise_of_samples>({.name = "largest_noise",
                                                 .sentence = "The largest one",
                                                 .quantity = &quantities::angle,
                                                 .absent = "all samples count the same"}),
    field<&Smoothing::degrees_of_freedom>(
        {.name = "degrees_of_freedom",
         .sentence = "Effective number of the curve's parameters, out of three for each key",
         .absent = "with a gyro"}),
    field<&Smoothing::rms_sigma>(
        {.name = "rms_sigma",
         .sentence = "Root mean square of the standard deviations of the orientations per axis",
         .quantity = &quantities::angle,
         .absent = "without `sigma`"}),
    field<&Smoothing::rms_sigma_of_rates>(
        {.name = "rms_sigma_of_rates",
         .sentence = "Root mean square of the standard deviations of the angular velocities per axis",
         .quantity = &quantities::rate,
         .absent = "without `sigma`"}),
    field<&of_gyro<&GyroFinding::used>>(
        {.name = "gyro_used",
         .sentence = "Whether the gyro counts; if not, the orientations come out better without it",
         .absent = "without a gyro"}),
    field<&of_gyro<&GyroFinding::noise>>({.name = "gyro_noise",
                                          .sentence = "σ of the noise of the gyro per axis",
                                          .quantity = &quantities::rate,
                                          .absent = "without a gyro"}),
    field<&gyro_correction>({.name = "gyro_correction",
                             .sentence = "Correction that is added to the rates of the gyro",
                             .quantity = &quantities::rate,
                             .absent = "without a gyro"}),
    field<&of_gyro<&GyroFinding::offset>>(
        {.name = "gyro_offset",
         .sentence = "By how much the stamps of the gyro are late, found or as stated",
         .quantity = &quantities::time,
         .absent = "without a gyro"}),
    field<&optional_of_gyro<&GyroFinding::offset_sigma>>(
        {.name = "gyro_offset_sigma",
         .sentence = "Its standard deviation",
         .quantity = &quantities::time,
         .absent = "without a gyro, as stated, or the motion does not tell it"}),
    field<&optional_of_gyro<&GyroFinding::drift>>(
        {.name = "gyro_drift",
         .sentence = "Standard deviation per axis of the change of a drifting bias in one second",
         .quantity = &quantities::rate,
         .absent = "without a gyro, or its bias is constant"}),
    field<&found_of_gyro<&GyroFinding::scale, 0>>(
        {.name = "gyro_scale",
         .sentence = "By which share of the true rate each axis of the gyro shows too much",
         .absent = "without a gyro that counts, or where the recording does not tell"}),
    field<&found_of_gyro<&GyroFinding::scale, 1>>({.name = "gyro_scale_sigma",
                                                   .sentence = "Standard deviations of these shares",
                                                   .absent = "where there are none"}),
    field<&found_of_gyro<&GyroFinding::mount, 0>>(
        {.name = "gyro_mount",
         .sentence = "Rotation vector of the turn that brings the rates of the gyro into the frame of the body",
         .quantity = &quantities::angle,
         .absent = "without a gyro that counts, or where the recording does not tell"}),
    field<&found_of_gyro<&GyroFinding::mount, 1>>({.name = "gyro_mount_sigma",
                                                   .sentence = "Standard deviations of its components",
                                                   .quantity = &quantities::angle,
                                                   .absent = "where there are none"}),
    field<&found_of_gyro<&GyroFinding::trend, 0>>(
        {.name = "gyro_trend",
         .sentence = "By which the correction grows in a second, from the middle of the recording",
         .quantity = &quantities::acceleration,
         .absent = "without a gyro that counts, or where the recording does not tell"}),
    field<&found_of_gyro<&GyroFinding::trend, 1>>({.name = "gyro_trend_sigma",
                                                   .sentence = "Standard deviations of its components",
                                                   .quantity = &quantities::acceleration,
                                                   .absent = "where there are none"}),
    field<&found_of_gyro<&GyroFinding::clock_rate, 0>>(
        {.name = "gyro_clock_rate",
         .sentence = "By which share of the time the clock of the gyro runs fast",
         .absent = "without a gyro with a clock of its own that counts, or where the recording does not tell"}),
    field<&found_of_gyro<&GyroFinding::clock_rate, 1>>({.name = "gyro_clock_rate_sigma",
                                                        .sentence = "Standard deviation of this share",
                                                        .absent = "where there is none"}),
    field<&correlated<&Smoothing::CorrelatedNoise::sigma>>(
        {.name = "correlated_noise",
         .sentence = "Standard deviation of the correlated part of the noise of the orientations, per axis",
         .quantity = &quantities::angle,
         .absent = "where the noise is white, or taken for it"}),
    field<&correlated<&Smoothing::CorrelatedNoise::time>>(
        {.name = "correlation_time",
         .sentence = "The time within which the correlation of this part falls to 1/e",
         .quantity = &quantities::time,
         .absent = "where there is none"}),
    field<&hidden<&Smoothing::CorrelatedNoise::sigma>>(
        {.name = "hidden_noise",
         .sentence = "Standard deviation per axis up to which noise that correlates could be hidden in the motion",
         .quantity = &quantities::angle,
         .absent = "where the noise is stated, or a gyro tells it"}),
    field<&hidden<&Smoothing::CorrelatedNoise::time>>(
        {.name = "hidden_noise_time",
         .sentence = "The time within which the correlation of such noise would fall to 1/e",
         .quantity = &quantities::time,
         .absent = "where there is none"}),
    field<&risk<&GyroFinding::Risk::with>>(
        {.name = "error_with_gyro",
         .sentence = "Root mean square of the error of the orientations that is to be expected with the gyro",
         .quantity = &quantities::angle,
         .absent = "without a gyro, or where it counts turns"}),
    field<&risk<&GyroFinding::Risk::without>>({.name = "error_without_gyro",
                                               .sentence = "Root mean square of that error without the gyro",
                                               .quantity = &quantities::angle,
                                               .absent = "without a gyro, or where it counts turns"}),
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
    field<&Smoothing::rejected>({.name = "rejected", .sentence = "Samples that were rejected as outliers"}),
    field<&rejected_gyro>({.name = "rejected_gyro", .sentence = "Samples whose rates were rejected"}),
    field<&Smoothing::retained_outlier_runs>({.name = "retained_outlier_runs",
                                              .sentence = "Samples as far away that were kept, since their neighbours "
                                                          "are far away too, or the motion does the like elsewhere"}),
    field<&Smoothing::samples_in_short_stretches>(
        {.name = "samples_in_short_stretches",
         .sentence = "Samples that were left out, because too few of them lie between two gaps"}),
    field<&Smoothing::stretches>({.name = "stretches", .sentence = "Stretches of the recording between gaps"}),
    field<&Smoothing::iterations>({.name = "iterations", .sentence = "Iterations of the last fit"}),
    field<&Smoothing::last_step>({.name = "last_step",
                                  .sentence = "Largest component by which an orientation moved in the last iteration",
                                  .quantity = &quantities::angle}),
};

constexpr std::array of_their_positions{
    field<&optional_of_positions<&PositionSmoothing::smoothing_time>>(
        {.name = "position_smoothing_time",
         .sentence = "Smoothing time τ of the positions",
         .quantity = &quantities::time,
         .absent = "no positions, or none with noise: they are as they were"}),
    field<&position_cutoff>({.name = "position_cutoff",
                             .sentence = "Cut-off frequency 1/(2πτ) of the positions",
                             .quantity = &quantities::frequency,
                             .absent = "no positions, or none with noise: they are as they were"}),
    field<&optional_of_positions<&PositionSmoothing::criterion>>(
        {.name = "position_criterion",
         .sentence = "How τ of the positions was chosen",
         .absent = "τ was given, or there was nothing to choose by"}),
    field<&of_positions<&PositionSmoothing::noise>>(
        {.name = "position_noise",
         .sentence = "σ of the noise of the positions per axis, from the residuals",
         .quantity = &quantities::length,
         .absent = "no positions"}),
    field<&of_positions<&PositionSmoothing::local_noise>>(
        {.name = "position_local_noise",
         .sentence = "σ of the noise per axis, from the differences between neighbours",
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
    field<&of_positions<&PositionSmoothing::rejected>>(
        {.name = "rejected_positions", .sentence = "Samples whose positions were rejected", .absent = "no positions"}),
    field<&of_positions<&PositionSmoothing::retained_outlier_runs>>(
        {.name = "retained_position_runs",
         .sentence = "Samples whose positions are as far away and were kept all the same",
         .absent = "no positions"}),
};

constexpr auto smoothing_results = [] {
  std::array<FieldInfo, of_orientations.size() + of_their_positions.size()> all{};
  std::ranges::copy(of_their_positions, std::ranges::copy(of_orientations, all.begin()).out);
  return all;
}();

}  // namespace

template <>
std::span<const FieldInfo> fields_of<SmoothOptions>() noexcept {
  return of_options;
}

template <>
std::span<const FieldInfo> fields_of<Smoothing>() noexcept {
  return smoothing_results;
}

}}  // namespace orispline
