// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/smooth.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/smoothing_words.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr std::size_t most_stretches_shown = 10;

const Track& recording_of(const SmoothOutcome& outcome) { return *outcome.request.recording; }

std::string samples_text(const SmoothOutcome& outcome) { return counted(recording_of(outcome).keys.size(), "sample"); }

/// `2: line 6 (5.2 s), line 9 (5.8 s)`
std::string counted_places(const SmoothOutcome& outcome, const std::vector<std::size_t>& samples) {
  return formatted("{}{}", samples.size(), places_text(samples, recording_of(outcome)));
}

std::string source_line(const SmoothOutcome& outcome) {
  std::string line = samples_text(outcome);
  if (const std::string& name = recording_of(outcome).name; !name.empty()) line += " from " + printable(name);
  if (!outcome.mended.empty()) line += "; " + outcome.mended;
  return line + "\n";
}

std::string noise_lines(const Smoothing& smoothing) {
  if (smoothing.correlated_noise && !smoothing.gyro)
    return formatted("noise           {:.4g}° per axis, correlated over {:.3g} s; {:.4g}° between neighbours\n",
                     smoothing.noise * degrees, smoothing.correlated_noise->time, smoothing.local_noise * degrees);
  std::string text = formatted("noise           {:.4g}° per axis in the residuals; {:.4g}° between neighbours\n",
                               smoothing.noise * degrees, smoothing.local_noise * degrees);
  if (smoothing.hidden_noise)
    text += formatted(
        "  correlated    it would stay in the motion; up to {:.2g}° could be hidden there, if correlated over {:.2g} "
        "s\n",
        smoothing.hidden_noise->sigma * degrees, smoothing.hidden_noise->time);
  return text;
}

std::string weights_line(const Smoothing& smoothing) {
  if (smoothing.noises.empty()) return "";
  return formatted("  of samples    {:.4g}° to {:.4g}°, by which they are weighed\n",
                   *smoothing.least_noise_of_samples() * degrees, *smoothing.largest_noise_of_samples() * degrees);
}

std::string distance_line(const Smoothing& smoothing) {
  const auto& [all, accepted] = std::tie(smoothing.distances, smoothing.accepted_distances);
  std::string text = formatted("distance        RMS {:.4g}°, largest {:.4g}° from the samples", all.rms * degrees,
                               all.largest * degrees);
  if (!smoothing.rejected.empty())
    text += formatted("; {:.4g}° and {:.4g}° without the rejected ones", accepted.rms * degrees,
                      accepted.largest * degrees);
  return text + "\n";
}

std::string freedom_line(const Smoothing& smoothing) {
  if (!smoothing.degrees_of_freedom) return "";
  return formatted("freedom         {:.4g} effective parameters of {}\n", *smoothing.degrees_of_freedom,
                   3 * smoothing.nodes.orientations.size());
}

std::string sigma_line(const Smoothing& smoothing) {
  if (!smoothing.sigmas) return "";
  return formatted("deviations      RMS {:.4g}° and {:.4g} °/s per axis\n", *smoothing.rms_sigma() * degrees,
                   *smoothing.rms_sigma_of_rates() * degrees);
}

/// Where the rates of the gyro are. It outlives them.
Places places_of_gyro(const SmoothOutcome& outcome) {
  const GyroRates& gyro = *outcome.request.gyro;
  const Decimal epoch = recording_of(outcome).epoch;
  return {.lines = gyro.lines, .time = [&gyro, epoch](std::size_t rate) {
            return gyro.exact_times.empty() ? epoch + Decimal::from_double(gyro.times[rate]) : gyro.exact_times[rate];
          }};
}

/// `99.1 ms late, σ 0.13 ms: corrected`
std::string clock_text(const GyroFinding& gyro, bool is_stated) {
  const double ms = gyro.offset * 1e3;
  const char* const side = ms >= 0.0 ? "late" : "early";
  if (is_stated) return formatted("{:.10g} ms {}, as stated", std::abs(ms), side);
  const std::string sure = gyro.offset_sigma ? formatted("σ {:.2g} ms", *gyro.offset_sigma * 1e3) : "";
  if (gyro.offset == 0.0)
    return sure.empty() ? "its offset cannot be told from this motion" : "no offset found, " + sure;
  return formatted("{:.5g} ms {}, {}{}", std::abs(ms), side, sure, gyro.used ? ": corrected" : "");
}

/// Samples before the first rate or behind the last one, on the corrected clock; single ones are left to the curve.
std::size_t samples_beyond_gyro(const SmoothOutcome& outcome) {
  constexpr std::ptrdiff_t fewest_to_tell = 3;
  const std::vector<double>& rates = outcome.request.gyro->times;
  const double offset = outcome.smoothing.gyro->offset;
  const auto count = std::ranges::count_if(recording_of(outcome).keys.times(), [&](double t) {
    return t + offset < rates.front() || t + offset > rates.back();
  });
  return count < fewest_to_tell ? 0 : static_cast<std::size_t>(count);
}

/// Scale, mount, trend and pace of the clock, where the gyro counts and the recording tells them.
std::string calibration_lines(const GyroFinding& gyro) {
  if (!gyro.used) return "";
  std::string text;
  if (gyro.scale) {
    const Eigen::Vector3d &scale = gyro.scale->value, &sigma = gyro.scale->sigma;
    text += formatted("  scale         {:.5g} ± {:.1g}, {:.5g} ± {:.1g}, {:.5g} ± {:.1g}: corrected\n", 1.0 + scale.x(),
                      sigma.x(), 1.0 + scale.y(), sigma.y(), 1.0 + scale.z(), sigma.z());
  }
  if (gyro.mount) {
    const Eigen::Vector3d axis = gyro.mount->value.normalized();
    text += formatted("  mount         {:.3g}° ± {:.1g}° about ({:.2g}, {:.2g}, {:.2g}): corrected\n",
                      gyro.mount->value.norm() * degrees, gyro.mount->sigma.maxCoeff() * degrees, axis.x(), axis.y(),
                      axis.z());
  }
  if (gyro.trend) {
    const Eigen::Vector3d trend = gyro.trend->value * degrees, sigma = gyro.trend->sigma * degrees;
    text += formatted("  trend         {:.3g} ± {:.1g}, {:.3g} ± {:.1g}, {:.3g} ± {:.1g} °/s in 1 s: corrected\n",
                      trend.x(), sigma.x(), trend.y(), sigma.y(), trend.z(), sigma.z());
  }
  if (gyro.clock_rate)
    text += formatted("  pace          {:.4g} ppm {} ± {:.1g}: corrected\n", std::abs(gyro.clock_rate->value) * 1e6,
                      gyro.clock_rate->value > 0.0 ? "fast" : "slow", gyro.clock_rate->sigma * 1e6);
  return text;
}

std::string gyro_lines(const SmoothOutcome& outcome) {
  const Smoothing& smoothing = outcome.smoothing;
  if (!smoothing.gyro) return "";
  const GyroFinding& gyro = *smoothing.gyro;
  std::string text = formatted("gyro            noise {:.4g} °/s per axis", gyro.noise * degrees);
  const Eigen::Vector3d bias = smoothing.nodes.gyro_correction * degrees;
  text +=
      gyro.used ? formatted(", correction {:.4g}, {:.4g}, {:.4g} °/s\n", bias.x(), bias.y(), bias.z()) : ", left out\n";
  text += formatted("  clock         {}\n", clock_text(gyro, outcome.request.options.gyro_offset.has_value()));
  text += calibration_lines(gyro);
  if (smoothing.correlated_noise)
    text += formatted("  orientations  noise correlated over {:.3g} s, {:.4g}° per axis beside the white noise\n",
                      smoothing.correlated_noise->time, smoothing.correlated_noise->sigma * degrees);
  if (gyro.drift) text += formatted("  bias          drifts by {:.3g} °/s in 1 s\n", *gyro.drift * degrees);
  if (gyro.risk && gyro.used)
    text += formatted("  error         {:.4g}° expected with the gyro, {:.4g}° without\n", gyro.risk->with * degrees,
                      gyro.risk->without * degrees);
  if (gyro.risk && !gyro.used)
    text += formatted("  error         {:.4g}° expected without the gyro\n", gyro.risk->without * degrees);
  if (const std::size_t beyond = samples_beyond_gyro(outcome); gyro.used && beyond > 0)
    text +=
        formatted("  beyond it     {}, {}\n", counted(beyond, "sample"),
                  smoothing.penalty == Penalty::jerk ? "to which the penalty of the jerk carries the accelerations on"
                                                     : "at whose end the acceleration is zero");
  if (!gyro.rejected.empty())
    text +=
        formatted("  rejected      {}{}\n", gyro.rejected.size(), places_text(gyro.rejected, places_of_gyro(outcome)));
  return text;
}

/// Whether the loss leaves outliers out.
bool rejects(Loss loss) { return loss == Loss::robust || loss == Loss::tukey; }

std::string outlier_lines(const SmoothOutcome& outcome) {
  const Smoothing& smoothing = outcome.smoothing;
  std::string text;
  if (rejects(outcome.request.options.loss))
    text += formatted("rejected        {}\n", counted_places(outcome, smoothing.rejected));
  if (const auto& kept = smoothing.retained_outlier_runs; !kept.empty())
    text += formatted(
        "far, but kept   {}; the samples beside them are far too, or the motion does the like "
        "elsewhere, which is rather motion than outliers (if they are faults, set the loss huber)\n",
        counted_places(outcome, kept));
  return text;
}

std::string position_lines(const SmoothOutcome& outcome) {
  if (!outcome.smoothing.positions) return "";
  const PositionSmoothing& found = *outcome.smoothing.positions;
  const auto& [all, accepted] = std::tie(found.distances, found.accepted_distances);
  std::string text = position_choice_line(outcome.smoothing);
  if (found.smoothing_time || !found.rejected.empty()) {
    text += formatted("  noise         {:.4g} m per axis in the residuals; {:.4g} m between neighbours\n", found.noise,
                      found.local_noise);
    text += formatted("  distance      RMS {:.4g} m, largest {:.4g} m from the samples", all.rms, all.largest);
    if (!found.rejected.empty())
      text += formatted("; {:.4g} m and {:.4g} m without the rejected ones", accepted.rms, accepted.largest);
    text += "\n";
  }
  if (rejects(outcome.request.options.loss))
    text += formatted("  rejected      {}\n", counted_places(outcome, found.rejected));
  if (const auto& kept = found.retained_outlier_runs; !kept.empty())
    text += formatted("  far, but kept {}\n", counted_places(outcome, kept));
  return text;
}

std::string stretch_lines(const SmoothOutcome& outcome) {
  const auto& stretches = outcome.smoothing.stretches;
  const Track& recording = recording_of(outcome);
  std::string text;
  if (const auto& few = outcome.smoothing.samples_in_short_stretches; !few.empty())
    text += formatted("left out        {}; too few between two gaps\n", counted_places(outcome, few));
  if (stretches.size() == 1) return text;
  text += formatted("stretches       {}, begun at", stretches.size());
  for (std::size_t i = 0; i < std::min(stretches.size(), most_stretches_shown); ++i)
    text += formatted("{} {}", i == 0 ? "" : ",", recording.time_text(recording.time_of(stretches[i].first)));
  return text + (stretches.size() > most_stretches_shown ? ", …\n" : "\n");
}

}  // namespace

std::string SmoothOutcome::result() const {
  return samples ? counted(*samples, "sample") : counted(smoothing.track.keys.size(), "key");
}

Expected<SmoothOutcome> smooth(SmoothRequest request, const Progress& progress) {
  const Track& recording = *request.recording;
  if (!request.options.gap && !request.options.gyro) request.options.gap = recording.recipe.gap;
  if (auto checked = check(request.options); !checked) return tl::unexpected(std::move(checked.error()));
  if (request.options.gyro && !request.gyro) {
    auto gyro = gyro_rates_in(recording);
    if (!gyro) return tl::unexpected(placed(recording, std::move(gyro.error())));
    request.gyro = std::make_shared<const GyroRates>(std::move(*gyro));
  }
  auto smoothing = request.gyro ? orispline::smooth(recording, *request.gyro, request.options, progress)
                                : orispline::smooth(recording, request.options, progress);
  if (!smoothing) return tl::unexpected(placed(recording, std::move(smoothing.error())));
  std::vector<Warning> warnings;
  for (const Warning& warning : smoothing->warnings) warnings.push_back(recording.located(warning));
  return SmoothOutcome{std::move(request), std::move(*smoothing), std::move(warnings)};
}

Json document_of(const SmoothOutcome& outcome) {
  const Track& recording = recording_of(outcome);
  Json json{{"samples", recording.keys.size()},
            {"rows_written", outcome.samples.value_or(outcome.smoothing.track.keys.size())},
            {"penalty", word_of(outcome.smoothing.penalty)},
            {"loss", word_of(outcome.request.options.loss)}};
  put(json, outcome.smoothing, places_of(recording));
  if (outcome.request.gyro) put(json, outcome.smoothing, {"rejected_gyro"}, places_of_gyro(outcome));
  return json;
}

std::string summary_of(const SmoothOutcome& outcome) {
  const Smoothing& smoothing = outcome.smoothing;
  return source_line(outcome) + choice_line(smoothing) + noise_lines(smoothing) + weights_line(smoothing) +
         distance_line(smoothing) + freedom_line(smoothing) + sigma_line(smoothing) + gyro_lines(outcome) +
         outlier_lines(outcome) + position_lines(outcome) + stretch_lines(outcome);
}

std::string line_of(const SmoothOutcome& outcome) {
  const SampleDistances& distances = outcome.smoothing.distances;
  std::string line = formatted("{} from {}, RMS {:.4g}° and at most {:.4g}° from them", outcome.result(),
                               samples_text(outcome), distances.rms * degrees, distances.largest * degrees);
  if (const auto& rejected = outcome.smoothing.rejected; !rejected.empty())
    line += formatted("; {} rejected", rejected.size());
  if (!outcome.mended.empty()) line += "; " + outcome.mended;
  return line;
}

}}}  // namespace orispline::jobs
