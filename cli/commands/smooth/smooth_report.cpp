// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth_report.hpp"

#include <algorithm>
#include <tuple>

#include <numbers>

#include <fmt/format.h>

#include "commands/sample/sample_report.hpp"
#include "options/quantity.hpp"
#include "output/summary.hpp"

namespace orispline::cli {
namespace {

using orispline::LambdaChoice;
using orispline::Smoothing;
using orispline::SmoothingCriterion;

constexpr std::size_t places_shown = 10;
constexpr std::size_t motion_run = 3;  // of rejected samples; --loss tukey may have it
constexpr double wanted_step = 1e-6;   // [rad] of the last step of the iteration

std::string reason_of(const Smoothing& smoothing) {
  if (!smoothing.criterion) return "as stated";
  std::string reason = *smoothing.criterion == SmoothingCriterion::gcv    ? "by generalised cross-validation"
                       : *smoothing.criterion == SmoothingCriterion::ubre ? "by the stated noise (UBRE)"
                                                                          : "by restricted likelihood (REML)";
  const std::size_t all = smoothing.keys.size();
  if (smoothing.chosen_on < all) reason += fmt::format(", on {} of {} samples", smoothing.chosen_on, all);
  return reason;
}

std::string noise_line(const SmoothReport& report) {
  const Smoothing& smoothing = report.smoothing;
  return fmt::format("noise           {:.4g}° per axis in the residuals; {:.4g}° between neighbours\n",
                     smoothing.noise * degrees, smoothing.local_noise * degrees);
}

std::string gyro_lines(const Smoothing& smoothing) {
  if (!smoothing.gyro_noise) return "";
  const Eigen::Vector3d bias = smoothing.nodes.gyro_correction * degrees;
  return fmt::format("gyro            noise {:.4g} °/s per axis, correction {:.4g}, {:.4g}, {:.4g} °/s\n",
                     *smoothing.gyro_noise * degrees, bias.x(), bias.y(), bias.z());
}

std::string outlier_lines(const SmoothReport& report) {
  std::string text;
  const auto& [rejected, kept] = std::tie(report.smoothing.rejected, report.smoothing.retained_outlier_runs);
  if (report.loss == orispline::Loss::robust || report.loss == orispline::Loss::tukey)
    text += fmt::format("rejected        {}{}\n", rejected.size(),
                        places_text(rejected, report.recording.lines, report.recording.exact_times));
  if (const auto& gyro = report.smoothing.rejected_gyro; !gyro.empty())
    text += fmt::format("gyro rejected   {}{}\n", gyro.size(),
                        places_text(gyro, report.recording.lines, report.recording.exact_times));
  if (!kept.empty())
    text += fmt::format("far, but kept   {}{}; three or more in a row are rather motion than outliers\n", kept.size(),
                        places_text(kept, report.recording.lines, report.recording.exact_times));
  return text;
}

std::string stretch_lines(const SmoothReport& report) {
  const auto& stretches = report.smoothing.stretches;
  const auto& samples_in_short_stretches = report.smoothing.samples_in_short_stretches;
  std::string text;
  if (!samples_in_short_stretches.empty())
    text += fmt::format("left out        {}{}; too few between two gaps\n", samples_in_short_stretches.size(),
                        places_text(samples_in_short_stretches, report.recording.lines, report.recording.exact_times));
  if (stretches.size() == 1) return text;
  text += fmt::format("stretches       {}, begun at", stretches.size());
  for (std::size_t i = 0; i < std::min(stretches.size(), places_shown); ++i)
    text += fmt::format("{} {} s", i == 0 ? "" : ",", report.recording.exact_times[stretches[i].first].to_string());
  return text + (stretches.size() > places_shown ? ", …\n" : "\n");
}

/// The longest run of rejected samples in one stretch.
std::size_t longest_rejected_run(const Smoothing& smoothing) {
  std::size_t longest = 0, run = 0;
  for (std::size_t k = 0; k < smoothing.rejected.size(); ++k) {
    const std::size_t sample = smoothing.rejected[k];
    const bool follows = k > 0 && smoothing.rejected[k - 1] + 1 == sample &&
                         !std::ranges::binary_search(smoothing.stretches, sample, {}, &orispline::Stretch::first);
    run = follows ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  return longest;
}

}  // namespace

double cutoff_of(const Smoothing& smoothing) { return 1.0 / (2.0 * std::numbers::pi * smoothing.smoothing_time); }

bool covers(const Smoothing& smoothing, std::span<const double> times, double t) {
  const auto behind = std::ranges::upper_bound(times, t);
  if (behind == times.begin()) return false;
  const auto before = behind - 1;  // the key
  const std::size_t sample = smoothing.keys[static_cast<std::size_t>(before - times.begin())];
  const auto next_stretch = std::ranges::upper_bound(smoothing.stretches, sample, {}, &orispline::Stretch::first);
  const auto& [first, count] = *(next_stretch - 1);
  return *before == t || sample + 1 < first + count;
}

std::string places_text(const std::vector<std::size_t>& samples, const std::vector<std::uint32_t>& lines,
                        const std::vector<Decimal>& times) {
  std::string text;
  for (std::size_t i = 0; i < std::min(samples.size(), places_shown); ++i)
    text += fmt::format("{}line {} ({} s)", i == 0 ? ": " : ", ", lines[samples[i]], times[samples[i]].to_string());
  return text + (samples.size() > places_shown ? ", …" : "");
}

std::string choice_line(const Smoothing& smoothing) {
  return fmt::format("smoothing time  {:.4g} s (cut-off {:.4g} Hz), {}\n", smoothing.smoothing_time,
                     cutoff_of(smoothing), reason_of(smoothing));
}

std::string remark_on(const Smoothing& smoothing) {
  if (smoothing.edge == LambdaChoice::Edge::shortest)
    return "hardly any noise was found beside the motion: the least smoothing was taken; state --smoothing-time for "
           "more or less";
  if (smoothing.edge == LambdaChoice::Edge::longest)
    return "no change of the rates was found beside the noise: the most smoothing was taken; state --smoothing-time "
           "to have less";
  if (const std::size_t run = longest_rejected_run(smoothing); run >= motion_run)
    return fmt::format(
        "{} samples in a row do not count, which is rather motion than outliers: wanted --loss robust, "
        "which keeps them",
        run);
  if (smoothing.last_step > wanted_step)
    return fmt::format("the last step of the iteration still moved by {:.2g} rad", smoothing.last_step);
  return "";
}

std::string text_of(const SmoothReport& report) {
  const Smoothing& smoothing = report.smoothing;
  std::string text = fmt::format("{} from {}", counted(report.recording.lines.size(), "sample"), report.recording.name);
  if (const std::string repairs = text_of(report.repairs); !repairs.empty()) text += "; " + repairs;
  text += "\n" + choice_line(smoothing);
  text += noise_line(report);
  if (smoothing.degrees_of_freedom)
    text += fmt::format("freedom         {:.4g} effective degrees of {}\n", *smoothing.degrees_of_freedom,
                        3 * smoothing.nodes.orientations.size());
  text += gyro_lines(smoothing) + outlier_lines(report) + stretch_lines(report);
  if (report.positions) text += "positions are as they were: only orientations are smoothed\n";
  return text + fmt::format("{} written to {}\n", counted(report.rows, report.samples ? "sample" : "key"),
                            destination(report.output));
}

}  // namespace orispline::cli
