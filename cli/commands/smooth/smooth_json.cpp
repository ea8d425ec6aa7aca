// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth.hpp"
#include "commands/smooth/smooth_report.hpp"
#include "output/smoothing_json.hpp"

namespace orispline::cli {
namespace {

Json stretches(const SmoothReport& report) {
  Json list = Json::array();
  for (const auto& [first, count] : report.smoothing.stretches)
    list.push_back({{"key", first}, {"line", report.recording.lines[first]}, {"samples", count}});
  return list;
}

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

std::string json_of(const SmoothReport& report) {
  const orispline::Smoothing& smoothing = report.smoothing;
  Json json{{"input", report.recording.name},
            {"output", report.output},
            {"samples", report.recording.lines.size()},
            {"rows_written", report.rows},
            {"penalty", word_of(penalty_choices, report.penalty)},
            {"loss", word_of(loss_choices, report.loss)},
            {"smoothing_time_s", smoothing.smoothing_time},
            {"cutoff_hz", smoothing.cutoff()},
            {"lambda", smoothing.lambda},
            {"criterion", criterion_of(smoothing)},
            {"chosen_on", smoothing.chosen_on},
            {"noise_rad", smoothing.noise},
            {"local_noise_rad", smoothing.local_noise},
            {"degrees_of_freedom", or_null(smoothing.degrees_of_freedom)},
            {"gyro_noise_rad_s", or_null(smoothing.gyro_noise)}};
  const Eigen::Vector3d& bias = smoothing.nodes.gyro_correction;
  json["gyro_correction_rad_s"] = smoothing.gyro_noise ? Json{bias.x(), bias.y(), bias.z()} : Json(nullptr);
  json["rejected"] = places_json(smoothing.rejected, report.recording.lines, report.recording.exact_times);
  json["rejected_gyro"] = places_json(smoothing.rejected_gyro, report.recording.lines, report.recording.exact_times);
  json["retained_outlier_runs"] =
      places_json(smoothing.retained_outlier_runs, report.recording.lines, report.recording.exact_times);
  json["samples_in_short_stretches"] =
      places_json(smoothing.samples_in_short_stretches, report.recording.lines, report.recording.exact_times);
  json["stretches"] = stretches(report);
  json["iterations"] = smoothing.iterations;
  json["last_step_rad"] = smoothing.last_step;
  return document(json);
}

}  // namespace orispline::cli
