// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/sample.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::size_t rate_orders_of(const Keyframes& keys) {
  const std::array rates{keys.angular_velocities(), keys.angular_accelerations(), keys.angular_jerks()};
  return static_cast<std::size_t>(std::ranges::count_if(rates, [](const auto& values) { return !values.empty(); }));
}

std::string keys_line(const SampleOutcome& outcome) {
  std::string line = counted(outcome.keys, "key");
  if (!outcome.source.empty()) line += formatted(" from {}", printable(outcome.source));
  line += formatted(", {} to {} s", outcome.start.to_string(), outcome.end.to_string());
  const KeyframeReport& keyframes = outcome.keyframes;
  if (keyframes.sign_flips > 0) line += formatted("; sign flips in the file: {}", keyframes.sign_flips);
  if (keyframes.non_unit_keys > 0) line += formatted("; {} normalised", keyframes.non_unit_keys);
  return line + "\n";
}

std::string lines_of_columns(const SampleOutcome& outcome) {
  constexpr std::array names{"angular velocities", "accelerations", "jerks"};
  std::string lines;
  if (outcome.rate_orders > 0)
    lines += formatted("rates taken from the keys: {}\n", joined(std::span(names).first(outcome.rate_orders), ", "));
  if (outcome.inner_quaternions) lines += "inner quaternions taken from the keys\n";
  return lines;
}

std::string truth_line(const TruthDistance& truth) {
  const DistanceStatistics& d = truth.distance;
  const std::string recording = printable(truth.recording);
  if (d.count == 0) return formatted("distance to {}: none of its times lies between the keys\n", recording);
  return formatted("distance to {}: RMS {:.4g}°, mean {:.4g}°, largest {:.4g}° at {} s; {} compared\n", recording,
                   d.rms * degrees, d.mean * degrees, d.largest * degrees, truth.largest_time.to_string(),
                   counted(d.count, "orientation")) +
         (truth.alignment ? "  " + line_of(*truth.alignment) + "\n" : "");
}

std::string outside_text(const SampleOutcome& outcome) {
  const auto how = std::ranges::find(words<Extrapolation>, static_cast<int>(outcome.extrapolation), &Word::value);
  const std::string_view sentence = !outcome.leaves_out         ? how->sentence
                                    : outcome.held_samples == 1 ? "is left out"
                                                                : "are left out";
  return formatted("{} outside the curve {}", counted(outcome.held_samples, "sample"), sentence);
}

std::string gap_text(const SampleOutcome& outcome) {
  return formatted("{} in gaps of the keys {}", counted(outcome.gap_samples, "sample"),
                   outcome.marks_gaps         ? "marked by empty rows"
                   : outcome.gap_samples == 1 ? "is left out"
                                              : "are left out");
}

Json truth_json(const TruthDistance& truth) {
  const DistanceStatistics& d = truth.distance;
  return {{"file", truth.recording},
          {"compared", d.count},
          {"distance_rms_deg", d.rms * degrees},
          {"distance_mean_deg", d.mean * degrees},
          {"distance_max_deg", d.largest * degrees},
          {"distance_max_time_s", truth.largest_time.to_string()},
          {"alignment", truth.alignment ? document_of(*truth.alignment) : Json(nullptr)}};
}

}  // namespace

TruthDistance distance_to_truth(const PoseCurve& curve, const Track& keys, const Track& truth) {
  const auto times = shifted(truth.keys.times(), (truth.epoch - keys.epoch).to_double());
  const Domain stretch{keys.keys.times().front(), keys.keys.times().back()};
  const auto distance = distance_to_reference(curve.orientation, {times, truth.keys.orientations()}, stretch);
  return {truth.name, distance, truth.time_of(distance.largest_at)};
}

Expected<TruthDistance> distance_to_aligned_truth(const PoseCurve& curve, std::shared_ptr<const Track> keys,
                                                  std::shared_ptr<const Track> truth) {
  return align({.moved = std::move(truth), .fixed = keys}).map([&](AlignOutcome outcome) {
    TruthDistance distance = distance_to_truth(curve, *keys, outcome.aligned);
    distance.alignment = std::move(outcome);
    return distance;
  });
}

bool could_be_measured(const SampleOutcome& outcome) {
  return outcome.method == default_method && outcome.keys >= families::least_weighed;
}

SampleOutcome outcome_of(const Track& keys, const Method& method, const CurveOfKeys& shaped) {
  const Domain domain = shaped.curve.orientation.domain();
  return {.source = keys.name,
          .method = method.name,
          .method_text = text_of(method),
          .keys = keys.keys.size(),
          .keyframes = keys.keys.report(),
          .rate_orders = rate_orders_of(keys.keys),
          .inner_quaternions = keys.keys.have_inner_quaternions(),
          .start = keys.epoch + Decimal::from_double(domain.start),
          .end = keys.epoch + Decimal::from_double(domain.end),
          .findings = shaped.findings};
}

std::string band_text(const SampleOutcome& outcome) {
  constexpr std::string_view reason = "the keys do not tell how far from the curve the motion was";
  if (outcome.without_band > 0 && outcome.without_band == outcome.samples)
    return formatted("the band is empty: {}", reason);
  const std::string text = formatted("the band is meant to hold {:.4g} % of the true motion", 100.0 * *outcome.band);
  if (outcome.without_band == 0) return text;
  return formatted("{}; it is empty at {}, where {}", text, counted(outcome.without_band, "sample"), reason);
}

Json document_of(const SampleOutcome& outcome, Json of_columns, Json of_repairs) {
  Json json{{"method", outcome.method},
            {"method_text", outcome.method_text},
            {"keys", outcome.keys},
            {"start_s", outcome.start.to_string()},
            {"end_s", outcome.end.to_string()},
            {"samples", outcome.samples},
            {"held_samples", outcome.held_samples},
            {"gap_samples", outcome.gap_samples}};
  json.update(std::move(of_columns));
  json["sign_flips"] = outcome.keyframes.sign_flips;
  json["non_unit_keys"] = outcome.keyframes.non_unit_keys;
  json.update(std::move(of_repairs));
  json["findings"] = findings_json(outcome.findings);
  json["band"] = outcome.band ? Json(*outcome.band) : Json(nullptr);
  json["truth"] = outcome.truth ? truth_json(*outcome.truth) : Json(nullptr);
  return json;
}

std::string summary_of(const SampleOutcome& outcome) {
  std::string text = keys_line(outcome);
  if (!outcome.mended.empty()) text += outcome.mended + "\n";
  text += lines_of_columns(outcome);
  text += formatted("{} with {}{}\n", counted(outcome.samples, "sample"), outcome.method_text,
                    outcome.written_to.empty() ? "" : " written to " + outcome.written_to);
  if (outcome.findings) text += "the keys say: " + findings_text(*outcome.findings) + "\n";
  if (outcome.band) text += band_text(outcome) + "\n";
  if (outcome.held_samples > 0) text += outside_text(outcome) + "\n";
  if (outcome.gap_samples > 0) text += gap_text(outcome) + "\n";
  return outcome.truth ? text + truth_line(*outcome.truth) : text;
}

std::string line_of(const SampleOutcome& outcome) {
  std::string line = formatted("{} with {} from {}", counted(outcome.samples, "sample"), outcome.method_text,
                               counted(outcome.keys, "key"));
  if (!outcome.mended.empty()) line += "; " + outcome.mended;
  if (outcome.held_samples > 0) line += "; " + outside_text(outcome);
  if (outcome.gap_samples > 0) line += "; " + gap_text(outcome);
  if (outcome.truth && outcome.truth->distance.count > 0)
    line += formatted("; RMS {:.4g}° and at most {:.4g}° from {}", outcome.truth->distance.rms * degrees,
                      outcome.truth->distance.largest * degrees, printable(outcome.truth->recording));
  return line;
}

}}}  // namespace orispline::jobs
