// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_scene_report.hpp"

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/reduce/reduce_fields.hpp>

#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// Of all clips together.
struct Totals {
  std::size_t tracks = 0, open_tracks = 0, keys = 0, keys_before = 0, translations = 0, translations_before = 0;
  /// The clips where these are largest.
  const ClipReduction *angle = nullptr, *distance = nullptr, *from_smooth = nullptr, *from_stored = nullptr;

  explicit Totals(const std::vector<ClipReduction>& reductions) {
    for (const ClipReduction& reduction : reductions) {
      tracks += reduction.rotation_tracks;
      open_tracks += reduction.open_tracks;
      keys += reduction.rotation_keys;
      keys_before += reduction.rotation_keys_before;
      translations += reduction.translation_keys;
      translations_before += reduction.translation_keys_before;
      take<&ClipReduction::angle>(angle, reduction);
      take<&ClipReduction::distance>(distance, reduction);
      take<&ClipReduction::from_smooth>(from_smooth, reduction);
      take<&ClipReduction::from_stored>(from_stored, reduction);
    }
  }

 private:
  template <ClipReduction::Worst ClipReduction::*Member>
  static void take(const ClipReduction*& worst, const ClipReduction& other) {
    if (!worst || (other.*Member).largest.value > (worst->*Member).largest.value) worst = &other;
  }
};

std::string place_of(const ReduceSceneReport& report, const ClipReduction& reduction,
                     const ClipReduction::Worst& worst) {
  return formatted("{}, at {:.6g} s", orispline::place_of(report.skeleton, reduction.clip, worst.joint),
                   worst.largest.time);
}

std::string size_text(std::size_t bytes) {
  const bool is_large = bytes >= 1'000'000;
  return formatted("{:.3g} {}", static_cast<double>(bytes) * (is_large ? 1e-6 : 1e-3), is_large ? "MB" : "kB");
}

Json worst_json(const ReduceSceneReport& report, const ClipReduction* reduction, const ClipReduction::Worst& worst,
                double unit) {
  return {{"largest", worst.largest.value * unit},
          {"clip", reduction->clip.name},
          {"joint", report.skeleton[worst.joint].name},
          {"time_s", worst.largest.time}};
}

}  // namespace

std::string text_of(const ReduceSceneReport& report) {
  const Totals totals(report.reductions);
  std::string text = formatted("{} from {}, tolerance {}, method {}\n", counted(report.reductions.size(), "clip"),
                               printable(report.input), tolerance_text(report.options, report.metres, report.unit),
                               report.options.method.name);
  if (totals.tracks > 0)
    text += formatted("rotations       {} of {} in {} of three keys and more ({:.1f} %)\n", totals.keys,
                      counted(totals.keys_before, "key"), counted(totals.tracks, "track"),
                      100.0 * static_cast<double>(totals.keys) / static_cast<double>(totals.keys_before));
  if (totals.translations < totals.translations_before)
    text += formatted("translations    {} of {}\n", totals.translations, counted(totals.translations_before, "key"));
  if (report.options.closed)
    text += formatted("closed          {} of {}: those that end as they begin\n", totals.tracks - totals.open_tracks,
                      counted(totals.tracks, "track"));
  if (totals.angle)
    text +=
        formatted("largest angle   {:.6g}° at every key of the input, {}\n",
                  totals.angle->angle.largest.value * degrees, place_of(report, *totals.angle, totals.angle->angle));
  if (totals.tracks > 0)
    text +=
        formatted("between keys    {:.6g}° from the curve auto through them, {:.6g}° from what the input has there\n",
                  totals.from_smooth->from_smooth.largest.value * degrees,
                  totals.from_stored->from_stored.largest.value * degrees);
  if (totals.distance)
    text += formatted("shell distance  {:.6g}{} in the world, {}; shell {:g}{}\n",
                      totals.distance->distance.largest.value * report.metres, report.unit,
                      place_of(report, *totals.distance, totals.distance->distance),
                      report.options.shell * report.metres, report.unit);
  text += formatted("written to {}", destination(report.output));
  if (report.bytes_before > 0)
    text += formatted(": {} of {}", size_text(report.bytes_after), size_text(report.bytes_before));
  return text + "\n";
}

std::string line_of(const ReduceSceneReport& report) {
  const Totals totals(report.reductions);
  return formatted("{}: {} of {}, {:.6g}° and {:.6g}{} in the world off at most", printable(report.output), totals.keys,
                   counted(totals.keys_before, "key"), totals.angle ? totals.angle->angle.largest.value * degrees : 0.0,
                   totals.distance ? totals.distance->distance.largest.value * report.metres : 0.0, report.unit);
}

Json json_of(const ReduceSceneReport& report) {
  const Totals totals(report.reductions);
  Json json{{"input", report.input}, {"output", report.output}, {"method", report.options.method.name}};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (report.options.tolerance < infinity) json["tolerance_deg"] = report.options.tolerance * degrees;
  if (report.options.position_tolerance < infinity)
    json["position_tolerance_m"] = report.options.position_tolerance * report.metres;
  if (report.options.world_tolerance < infinity)
    json["world_tolerance_m"] = report.options.world_tolerance * report.metres;
  json["shell_m"] = report.options.shell * report.metres;
  json["clips"] = report.reductions.size();
  json["rotation_tracks"] = totals.tracks;
  json["rotation_keys_before"] = totals.keys_before;
  json["rotation_keys"] = totals.keys;
  json["translation_keys_before"] = totals.translations_before;
  json["translation_keys"] = totals.translations;
  if (report.options.closed) json["open_tracks"] = totals.open_tracks;
  if (totals.angle) json["angle_deg"] = worst_json(report, totals.angle, totals.angle->angle, degrees);
  if (totals.distance)
    json["shell_distance_m"] = worst_json(report, totals.distance, totals.distance->distance, report.metres);
  if (totals.tracks > 0) {
    json["from_smooth_deg"] = worst_json(report, totals.from_smooth, totals.from_smooth->from_smooth, degrees);
    json["from_stored_deg"] = worst_json(report, totals.from_stored, totals.from_stored->from_stored, degrees);
  }
  if (report.bytes_before > 0) json["bytes_before"] = report.bytes_before;
  json["bytes"] = report.bytes_after;
  return json;
}

}  // namespace orispline::cli
