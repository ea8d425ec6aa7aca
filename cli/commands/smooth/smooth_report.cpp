// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth_report.hpp"

#include <algorithm>
#include <tuple>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>

#include "output/repairs_text.hpp"
#include "output/smoothing_text.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

using orispline::Smoothing;

constexpr std::size_t stretches_shown = 10;

std::string noise_line(const SmoothReport& report) {
  const Smoothing& smoothing = report.smoothing;
  return formatted("noise           {:.4g}° per axis in the residuals; {:.4g}° between neighbours\n",
                   smoothing.noise * degrees, smoothing.local_noise * degrees);
}

std::string distance_lines(const Smoothing& smoothing) {
  const auto& [all, accepted] = std::tie(smoothing.distances, smoothing.accepted_distances);
  std::string text = formatted("distance        RMS {:.4g}°, largest {:.4g}° from the samples", all.rms * degrees,
                               all.largest * degrees);
  if (!smoothing.rejected.empty())
    text += formatted("; {:.4g}° and {:.4g}° without the rejected ones", accepted.rms * degrees,
                      accepted.largest * degrees);
  return text + "\n";
}

std::string sigma_line(const Smoothing& smoothing) {
  if (!smoothing.sigmas) return "";
  return formatted("deviations      RMS {:.4g}° and {:.4g} °/s per axis\n", *smoothing.rms_sigma() * degrees,
                   *smoothing.rms_sigma_of_rates() * degrees);
}

std::string gyro_lines(const Smoothing& smoothing) {
  if (!smoothing.gyro_noise) return "";
  const Eigen::Vector3d bias = smoothing.nodes.gyro_correction * degrees;
  return formatted("gyro            noise {:.4g} °/s per axis, correction {:.4g}, {:.4g}, {:.4g} °/s\n",
                   *smoothing.gyro_noise * degrees, bias.x(), bias.y(), bias.z());
}

std::string outlier_lines(const SmoothReport& report) {
  std::string text;
  const auto& [rejected, kept] = std::tie(report.smoothing.rejected, report.smoothing.retained_outlier_runs);
  if (report.loss == orispline::Loss::robust || report.loss == orispline::Loss::tukey)
    text += formatted("rejected        {}{}\n", rejected.size(),
                      places_text(rejected, report.recording.lines, report.recording.exact_times));
  if (const auto& gyro = report.smoothing.rejected_gyro; !gyro.empty())
    text += formatted("gyro rejected   {}{}\n", gyro.size(),
                      places_text(gyro, report.recording.lines, report.recording.exact_times));
  if (!kept.empty())
    text +=
        formatted("far, but kept   {}{}; the samples beside them are far too, which is rather motion than outliers\n",
                  kept.size(), places_text(kept, report.recording.lines, report.recording.exact_times));
  return text;
}

std::string position_lines(const SmoothReport& report) {
  if (!report.smoothing.positions) return "";
  const orispline::PositionSmoothing& found = *report.smoothing.positions;
  const auto& [all, accepted] = std::tie(found.distances, found.accepted_distances);
  const auto places = [&report](const std::vector<std::size_t>& samples) {
    return places_text(samples, report.recording.lines, report.recording.exact_times);
  };
  std::string text = position_choice_line(report.smoothing);
  if (found.smoothing_time || !found.rejected.empty()) {
    text += formatted("  noise         {:.4g} m per axis in the residuals; {:.4g} m between neighbours\n", found.noise,
                      found.local_noise);
    text += formatted("  distance      RMS {:.4g} m, largest {:.4g} m from the samples", all.rms, all.largest);
    if (!found.rejected.empty())
      text += formatted("; {:.4g} m and {:.4g} m without the rejected ones", accepted.rms, accepted.largest);
    text += "\n";
  }
  if (report.loss == orispline::Loss::robust || report.loss == orispline::Loss::tukey)
    text += formatted("  rejected      {}{}\n", found.rejected.size(), places(found.rejected));
  if (const auto& kept = found.retained_outlier_runs; !kept.empty())
    text += formatted("  far, but kept {}{}\n", kept.size(), places(kept));
  return text;
}

std::string stretch_lines(const SmoothReport& report) {
  const auto& stretches = report.smoothing.stretches;
  const auto& samples_in_short_stretches = report.smoothing.samples_in_short_stretches;
  std::string text;
  if (!samples_in_short_stretches.empty())
    text += formatted("left out        {}{}; too few between two gaps\n", samples_in_short_stretches.size(),
                      places_text(samples_in_short_stretches, report.recording.lines, report.recording.exact_times));
  if (stretches.size() == 1) return text;
  text += formatted("stretches       {}, begun at", stretches.size());
  for (std::size_t i = 0; i < std::min(stretches.size(), stretches_shown); ++i)
    text += formatted("{} {} s", i == 0 ? "" : ",", report.recording.exact_times[stretches[i].first].to_string());
  return text + (stretches.size() > stretches_shown ? ", …\n" : "\n");
}

}  // namespace

std::string text_of(const SmoothReport& report) {
  const Smoothing& smoothing = report.smoothing;
  std::string text =
      formatted("{} from {}", counted(report.recording.keys.size(), "sample"), printable(report.recording.name));
  text += clauses_of(report.repairs);
  text += "\n" + choice_line(smoothing);
  text += noise_line(report) + distance_lines(smoothing);
  if (smoothing.degrees_of_freedom)
    text += formatted("freedom         {:.4g} effective parameters of {}\n", *smoothing.degrees_of_freedom,
                      3 * smoothing.nodes.orientations.size());
  text += sigma_line(smoothing) + gyro_lines(smoothing) + outlier_lines(report) + position_lines(report) +
          stretch_lines(report);
  return text + formatted("{} written to {}\n", counted(report.rows, report.samples ? "sample" : "key"),
                          destination(report.output));
}

std::string line_of(const SmoothReport& report) {
  std::string line = formatted("{}: {} from {}, RMS {:.4g}° and at most {:.4g}° from them", printable(report.output),
                               counted(report.rows, report.samples ? "sample" : "key"),
                               counted(report.recording.keys.size(), "sample"),
                               report.smoothing.distances.rms * degrees, report.smoothing.distances.largest * degrees);
  if (!report.smoothing.rejected.empty()) line += formatted("; {} rejected", report.smoothing.rejected.size());
  line += clauses_of(report.repairs);
  return line;
}

}  // namespace orispline::cli
